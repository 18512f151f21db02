/** The graph of the program in view. */
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { deleteSelection, duplicateSelection } from "../../session/edits";
import type { Feature } from "../../session/features";
import { GRAPH_KEYS, keyFor, type PageKey } from "../../session/key-table";
import type { MenuEntries } from "../../session/menu-table";
import { openFind, toggleLive, useView } from "../../session/view";
import { menuCheck, menuItem } from "../../ui/menu-model";
import { Canvas } from "./Canvas";
import { copySelection, cutSelection, pasteFromMenu } from "./clipboard";
import { selectAll } from "./keys";

/** The entries of the menus that work on the graph: the selection, the search, the view. */
const KEYS = {
  find: { chords: ["Ctrl+F"], says: "help.keys-find", typing: true, run: openFind },
} satisfies Record<string, PageKey>;

function useCanvasMenu(): MenuEntries {
  const nothing = useStudio((studio) => studio.selection.length === 0);
  const viewport = useView((view) => view.viewport);
  const live = useView((view) => view.live);
  const away = viewport === null;
  return {
    clipboard: [
      menuItem("edit-cut", t("edit.cut"), keyFor.clipboard(0), cutSelection, nothing),
      menuItem("edit-copy", t("edit.copy"), keyFor.clipboard(1), copySelection, nothing),
      menuItem("edit-paste", t("edit.paste"), keyFor.clipboard(2), pasteFromMenu),
      menuItem("edit-delete", t("edit.delete"), keyFor.graph("remove"), deleteSelection, nothing),
      menuItem("edit-duplicate", t("edit.duplicate"), keyFor.graph("duplicate"), duplicateSelection, nothing),
      menuItem("edit-select-all", t("edit.select-all"), keyFor.graph("all"), selectAll),
    ],
    find: [menuItem("edit-find", t("edit.find"), keyFor.page(KEYS.find), openFind)],
    viewport: [
      menuItem("view-fit", t("view.fit"), keyFor.graph("fit"), () => viewport?.fit(), away),
      menuItem(
        "view-selection",
        t("graph.zoom-selection"),
        keyFor.graph("zoomSelection"),
        () => viewport?.zoomToSelection(),
        away,
      ),
      menuItem("view-home", t("view.home"), keyFor.graph("home"), () => viewport?.home(), away),
      menuItem("view-zoom-in", t("view.zoom-in"), keyFor.graph("zoomIn"), () => viewport?.zoomIn(), away),
      menuItem("view-zoom-out", t("view.zoom-out"), keyFor.graph("zoomOut"), () => viewport?.zoomOut(), away),
      menuCheck("view-live", t("graph.live"), live, toggleLive),
    ],
  };
}

export const canvas: Feature = {
  name: "canvas",
  panels: { graph: Canvas },
  keys: KEYS,
  keyTables: [{ heading: "app.canvas", rows: GRAPH_KEYS }],
  words: { "view-live": "search.live" },
  useMenu: useCanvasMenu,
};
