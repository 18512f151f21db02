/** What the menu of the canvas offers: for selected vertices, for a selected arc, for the canvas as a whole. */
import { unwrapPart, wraps } from "../model/commands/wrapParts";
import { useStudio } from "../model/studio";
import type { MenuEntry } from "../shell/menu-model";
import { t } from "../words/words";
import { copySelection, cutSelection, pasteFromMenu } from "./clipboard";
import { currentDrawing } from "./drawing";
import { deleteSelection, duplicateSelection, openWrapping, unwrapSelection, wrappable } from "./edits";
import { toggleFoldOfSelection } from "./folded";
import { editSelected, openAdding, selectAll } from "./keys";
import { isNoted, openNote, removeNote } from "./Notes";
import { useView } from "./view";

function item(id: string, label: string, keys: string, run: () => unknown, disabled = false): MenuEntry {
  return { kind: "item", id: `context-${id}`, label, keys, disabled, run: () => void run() };
}

const line = (id: string): MenuEntry => ({ kind: "line", id: `context-${id}` });

export function contextEntries(): MenuEntry[] {
  const paste = item("paste", t("edit.paste"), "Ctrl+V", pasteFromMenu);
  if (useStudio.getState().selection.length > 0) return vertexEntries(paste);
  if (useView.getState().arc !== null) return [item("add", t("context.add-here"), "/", openAdding), paste];
  const { viewport } = useView.getState();
  return [
    item("add", t("context.add-here"), "/", openAdding),
    paste,
    line("1"),
    item("select-all", t("edit.select-all"), "Ctrl+A", selectAll),
    line("2"),
    item("fit", t("view.fit"), "", () => viewport?.fit()),
    item("home", t("view.home"), "Ctrl+0", () => viewport?.home()),
  ];
}

function noteEntries(id: string | undefined, start: boolean): MenuEntry[] {
  if (id === undefined || start) return [];
  const write = item("note", t("context.note"), "N", openNote);
  return isNoted(id) ? [write, item("unnote", t("context.unnote"), "", removeNote)] : [write];
}

function vertexEntries(paste: MenuEntry): MenuEntry[] {
  const { selection } = useStudio.getState();
  const drawing = currentDrawing();
  const shapes = selection.flatMap(
    (id) => drawing?.parts.shape(drawing.program.vertices.find((one) => one.id === id)?.element ?? "") ?? [],
  );
  const fixed = shapes.every(({ kind }) => kind === "start" || kind === "stop");
  const only = selection.length === 1 ? selection[0] : undefined;
  const settable = shapes.length === 1 && shapes.some(({ fields, plugs }) => fields.length + plugs.length > 0);
  const unwraps = drawing !== null && only !== undefined && unwrapPart(drawing.program, drawing.parts, only) !== null;
  const node = only === undefined ? undefined : drawing?.nodes.get(only);
  return [
    item("edit", t("context.edit"), "Enter", editSelected, !settable),
    item("add", t("context.add-after"), "/", openAdding),
    line("1"),
    item("cut", t("edit.cut"), "Ctrl+X", cutSelection, fixed),
    item("copy", t("edit.copy"), "Ctrl+C", copySelection, fixed),
    paste,
    item("duplicate", t("edit.duplicate"), "Ctrl+D", duplicateSelection, fixed),
    line("2"),
    ...noteEntries(
      only,
      shapes.some(({ kind }) => kind === "start"),
    ),
    item("wrap", t("context.wrap"), "W", openWrapping, !wrappable() || drawing?.parts.all.some(wraps) !== true),
    ...(unwraps ? [item("unwrap", t("context.unwrap"), "Shift+W", unwrapSelection)] : []),
    ...(node?.inside != null || (node?.block?.bodies.length ?? 0) > 0
      ? [item("fold", t(node?.inside == null ? "context.fold" : "context.unfold"), "C", toggleFoldOfSelection)]
      : []),
    item("zoom", t("graph.zoom-selection"), "Z", () => useView.getState().viewport?.zoomToSelection()),
    line("3"),
    item("delete", t("edit.delete"), "Del", deleteSelection, fixed),
  ];
}
