/** The entries of the menus that work on the graph: undo, redo, the selection, the view. */
import { copySelection, cutSelection, pasteFromMenu } from "../editor/clipboard";
import { deleteSelection, duplicateSelection } from "../editor/edits";
import { selectAll } from "../editor/keys";
import { openFind, type Viewport } from "../editor/view";
import type { StudioState } from "../model/studio";
import { keyFor } from "../reach/key-table";
import { t } from "../words/words";
import type { MenuEntry } from "./menu-model";

export function editEntries(studio: StudioState): MenuEntry[] {
  const { undo, redo, canUndo, canRedo, undoLabel, redoLabel, selection } = studio;
  return [
    {
      kind: "item",
      id: "edit-undo",
      label: undoLabel === "" ? t("edit.undo") : t("edit.undo-what", { what: undoLabel }),
      keys: keyFor.page("undo"),
      disabled: !canUndo,
      run: undo,
    },
    {
      kind: "item",
      id: "edit-redo",
      label: redoLabel === "" ? t("edit.redo") : t("edit.redo-what", { what: redoLabel }),
      keys: keyFor.page("redo"),
      disabled: !canRedo,
      run: redo,
    },
    { kind: "line", id: "edit-1" },
    {
      kind: "item",
      id: "edit-cut",
      label: t("edit.cut"),
      keys: keyFor.clipboard(0),
      disabled: selection.length === 0,
      run: () => void cutSelection(),
    },
    {
      kind: "item",
      id: "edit-copy",
      label: t("edit.copy"),
      keys: keyFor.clipboard(1),
      disabled: selection.length === 0,
      run: () => void copySelection(),
    },
    {
      kind: "item",
      id: "edit-paste",
      label: t("edit.paste"),
      keys: keyFor.clipboard(2),
      run: () => void pasteFromMenu(),
    },
    {
      kind: "item",
      id: "edit-delete",
      label: t("edit.delete"),
      keys: keyFor.graph("remove"),
      disabled: selection.length === 0,
      run: () => void deleteSelection(),
    },
    {
      kind: "item",
      id: "edit-duplicate",
      label: t("edit.duplicate"),
      keys: keyFor.graph("duplicate"),
      disabled: selection.length === 0,
      run: () => void duplicateSelection(),
    },
    {
      kind: "item",
      id: "edit-select-all",
      label: t("edit.select-all"),
      keys: keyFor.graph("all"),
      run: selectAll,
    },
    { kind: "line", id: "edit-2" },
    {
      kind: "item",
      id: "edit-find",
      label: t("edit.find"),
      keys: keyFor.page("find"),
      run: openFind,
    },
  ];
}

export function viewEntries(viewport: Viewport | null): MenuEntry[] {
  const item = (
    id: string,
    label: string,
    keys: Parameters<typeof keyFor.graph>[0],
    run: (() => void) | undefined,
  ): MenuEntry => ({
    kind: "item",
    id,
    label,
    keys: keyFor.graph(keys),
    disabled: run === undefined,
    run: run ?? (() => undefined),
  });
  return [
    item("view-fit", t("view.fit"), "fit", viewport?.fit),
    item("view-selection", t("graph.zoom-selection"), "zoomSelection", viewport?.zoomToSelection),
    item("view-home", t("view.home"), "home", viewport?.home),
    item("view-zoom-in", t("view.zoom-in"), "zoomIn", viewport?.zoomIn),
    item("view-zoom-out", t("view.zoom-out"), "zoomOut", viewport?.zoomOut),
  ];
}
