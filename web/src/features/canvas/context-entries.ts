/** What the menu of the canvas offers: for selected vertices, for a selected arc, for the canvas as a whole. */
import { t } from "../../i18n/words";
import { unwrapPart, wraps } from "../../model/commands/wrapParts";
import { useStudio } from "../../model/studio";
import { toggleBreakpoints } from "../../session/breakpoints";
import { isOwn, openEdit, openSave } from "../../session/custom-blocks";
import { currentDrawing } from "../../session/drawing";
import { deleteSelection, duplicateSelection, openWrapping, unwrapSelection, wrappable } from "../../session/edits";
import { keyFor } from "../../session/key-table";
import { isShown } from "../../session/simple-view";
import { canVarySelected, varySelected } from "../../session/varied-axes";
import { editSelected, openAdding, useView } from "../../session/view";
import { type MenuEntry, menuItem } from "../../ui/menu-model";
import { copySelection, cutSelection, pasteFromMenu } from "./clipboard";
import { toggleFoldOfSelection } from "./fold-state";
import { selectAll } from "./keys";
import { isNoted, openNote, removeNote } from "./Notes";

const item: typeof menuItem = (id, ...rest) => menuItem(`context-${id}`, ...rest);

const line = (id: string): MenuEntry => ({ kind: "line", id: `context-${id}` });

export function contextEntries(): MenuEntry[] {
  const paste = item("paste", t("edit.paste"), keyFor.clipboard(2), pasteFromMenu);
  if (useStudio.getState().selection.length > 0) return vertexEntries(paste);
  if (useView.getState().arc !== null)
    return [item("add", t("context.add-here"), keyFor.graph("add"), openAdding), paste];
  const { viewport } = useView.getState();
  return [
    item("add", t("context.add-here"), keyFor.graph("add"), openAdding),
    paste,
    line("1"),
    item("select-all", t("edit.select-all"), keyFor.graph("all"), selectAll),
    line("2"),
    item("fit", t("view.fit"), keyFor.graph("fit"), () => viewport?.fit()),
    item("home", t("view.home"), keyFor.graph("home"), () => viewport?.home()),
  ];
}

function noteEntries(id: string | undefined, start: boolean): MenuEntry[] {
  if (id === undefined || start) return [];
  const write = item("note", t("context.note"), keyFor.graph("note"), openNote);
  return isNoted(id) ? [write, item("unnote", t("context.unnote"), null, removeNote)] : [write];
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
    item("edit", t("context.edit"), keyFor.graph("edit"), editSelected, !settable),
    item("add", t("context.add-after"), keyFor.graph("add"), openAdding),
    line("1"),
    item("cut", t("edit.cut"), keyFor.clipboard(0), cutSelection, fixed),
    item("copy", t("edit.copy"), keyFor.clipboard(1), copySelection, fixed),
    paste,
    item("duplicate", t("edit.duplicate"), keyFor.graph("duplicate"), duplicateSelection, fixed),
    line("2"),
    ...noteEntries(
      only,
      shapes.some(({ kind }) => kind === "start"),
    ),
    item(
      "wrap",
      t("context.wrap"),
      keyFor.graph("wrap"),
      openWrapping,
      !wrappable() || drawing?.parts.all.some(wraps) !== true,
    ),
    ...(unwraps ? [item("unwrap", t("context.unwrap"), keyFor.graph("unwrap"), unwrapSelection)] : []),
    ...(node?.inside != null || (node?.block?.bodies.length ?? 0) > 0
      ? [
          item(
            "fold",
            t(node?.inside == null ? "context.fold" : "context.unfold"),
            keyFor.graph("fold"),
            toggleFoldOfSelection,
          ),
        ]
      : []),
    item("breakpoint", t("debug.toggle"), keyFor.graph("breakpoint"), toggleBreakpoints, fixed),
    ...(canVarySelected() && isShown("verification")
      ? [item("vary", t("experiment.vary-part"), keyFor.graph("vary"), varySelected)]
      : []),
    item("save-part", t("own.save"), keyFor.graph("savePart"), openSave, fixed),
    ...shapes
      .filter((shape) => shapes.length === 1 && isOwn(shape))
      .map(({ element }) => item("edit-part", t("own.edit"), null, () => openEdit(element))),
    item("zoom", t("graph.zoom-selection"), keyFor.graph("zoomSelection"), () =>
      useView.getState().viewport?.zoomToSelection(),
    ),
    line("3"),
    item("delete", t("edit.delete"), keyFor.graph("remove"), deleteSelection, fixed),
  ];
}
