/** The canvas's keys. They hold while the canvas, or nothing at all, has the focus; some of them also in the palette. */
import { type RefObject, useEffect } from "react";

import { useStudio } from "../../model/studio";
import { toggleBreakpoints } from "../../session/breakpoints";
import { openSave } from "../../session/custom-blocks";
import { currentDrawing, nodeOf } from "../../session/drawing";
import {
  deleteSelection,
  duplicateSelection,
  openWrapping,
  shiftSelection,
  unwrapSelection,
} from "../../session/edits";
import { GRAPH_KEYS, keyIn } from "../../session/key-table";
import { varySelected } from "../../session/varied-axes";
import {
  dropArc,
  editSelected,
  openAdding,
  openField,
  toggleFollowing,
  toggleMinimap,
  useView,
} from "../../session/view";
import { listen } from "../../ui/effects";
import { openContextMenu } from "./context";
import { toggleFoldOfSelection } from "./fold-state";
import { openNote } from "./Notes";
import { type Step, walk } from "./walk";

function step(direction: Step): boolean {
  const drawing = currentDrawing();
  const { selection, select } = useStudio.getState();
  const arc = drawing?.layout.arcs.find((one) => one.id === useView.getState().arc);
  // From an arc, up is where it comes from and down what comes after that.
  if (arc !== undefined && drawing !== null && direction === "up")
    select([nodeOf(drawing, arc.source)?.vertex ?? arc.source]);
  else {
    const from = selection.at(-1) ?? (arc === undefined ? null : arc.source);
    const next = drawing === null ? null : walk(drawing, from, direction);
    if (next !== null) select([next]);
  }
  return true;
}

/** Takes the next vertex to those that are selected. */
function extend(direction: "up" | "down"): boolean {
  const drawing = currentDrawing();
  const { selection, select } = useStudio.getState();
  const next = drawing === null ? null : walk(drawing, selection.at(-1) ?? null, direction);
  if (next === null) return true;
  // Back over what was taken last lets it go.
  select(selection.at(-2) === next ? selection.slice(0, -1) : [...selection.filter((one) => one !== next), next]);
  return true;
}

/** Selects an arc that leaves the selected vertex, then the next one: into its bodies first, then on. */
function selectArc(): boolean {
  const drawing = currentDrawing();
  const { arc, selectArc: choose } = useView.getState();
  if (drawing === null) return false;
  const last = useStudio.getState().selection.at(-1);
  const node = last === undefined ? undefined : nodeOf(drawing, last);
  const source = drawing.layout.arcs.find((one) => one.id === arc)?.source;
  const owners = last === undefined ? [source ?? "start"] : [node?.vertex ?? last, node?.mark?.vertex.id];
  const leaving = [...new Set(drawing.layout.arcs.filter((one) => owners.includes(one.source)).map((one) => one.id))];
  const sorted = [...leaving.filter((id) => !id.endsWith(".next")), ...leaving.filter((id) => id.endsWith(".next"))];
  const next = sorted[(arc === null ? 0 : sorted.indexOf(arc) + 1) % Math.max(1, sorted.length)];
  if (next === undefined) return false;
  choose(next);
  return true;
}

/** Every vertex that stands in a chain; what is inside them goes along. */
export function selectAll(): void {
  const nodes = currentDrawing()?.layout.nodes.filter((node) => node.block !== null && node.kind !== "barEnd") ?? [];
  useStudio.getState().select(nodes.map((node) => node.vertex));
}

/** Enter goes to the first thing that can be set on the selected vertex. */
function escape(): boolean {
  const { arc, adding } = useView.getState();
  if (adding === null && arc === null && useStudio.getState().selection.length === 0) return false;
  dropArc();
  useStudio.getState().select([]);
  return true;
}

const yes = (act: (() => void) | undefined): boolean => {
  act?.();
  return true;
};

/** Each does what its key means and says whether it meant anything. */
const ACTIONS: Record<keyof typeof GRAPH_KEYS, () => boolean> = {
  add: openAdding,
  up: () => step("up"),
  down: () => step("down"),
  left: () => step("left"),
  right: () => step("right"),
  arc: selectArc,
  extendUp: () => extend("up"),
  extendDown: () => extend("down"),
  all: () => yes(selectAll),
  edit: editSelected,
  note: openNote,
  earlier: () => shiftSelection(-1),
  later: () => shiftSelection(1),
  remove: deleteSelection,
  duplicate: () => yes(duplicateSelection),
  wrap: openWrapping,
  unwrap: unwrapSelection,
  fold: toggleFoldOfSelection,
  savePart: openSave,
  vary: varySelected,
  breakpoint: toggleBreakpoints,
  menu: openContextMenu,
  zoomSelection: () => yes(useView.getState().viewport?.zoomToSelection),
  fit: () => yes(useView.getState().viewport?.fit),
  zoomIn: () => yes(useView.getState().viewport?.zoomIn),
  zoomOut: () => yes(useView.getState().viewport?.zoomOut),
  home: () => yes(useView.getState().viewport?.home),
  minimap: () => yes(toggleMinimap),
  follow: () => yes(toggleFollowing),
  nothing: escape,
};

export function useCanvasKeys(root: RefObject<HTMLDivElement | null>): void {
  useEffect(() => {
    const onKey = (event: KeyboardEvent) => {
      const target = event.target instanceof Element ? event.target : document.body;
      if (
        event.defaultPrevented ||
        target.closest("input, textarea, select, [contenteditable=true], [role=dialog], .in-place")
      )
        return;
      const inPalette = target.closest("[role=tree]") !== null;
      if (target !== document.body && !inPalette && root.current?.contains(target) !== true) return;
      // The tree of parts walks and adds by the same keys.
      const removes = event.key === "Delete" || event.key === "Backspace";
      if (inPalette && !event.ctrlKey && !event.metaKey && !removes) return;
      // So do parts that can be removed themselves.
      if (removes && target.closest("[data-removable]") !== null) return;
      // A focused button of the canvas keeps its own Enter.
      if (event.key === "Enter" && target.closest("button") !== null) return;
      const id = keyIn(GRAPH_KEYS, event);
      const last = useStudio.getState().selection.at(-1);
      // A digit is typed over the value of what is selected.
      if (id === null && last !== undefined && /^\p{Nd}$/u.test(event.key) && !event.ctrlKey && !event.altKey) {
        openField(last, "", event.key);
        event.preventDefault();
      }
      if (id !== null && ACTIONS[id]()) event.preventDefault();
    };
    return listen(window, { keydown: onKey }, { capture: true });
  }, [root]);
}
