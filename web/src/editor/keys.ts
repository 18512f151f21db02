/** The canvas's keys. They hold while the canvas, or nothing at all, has the focus; some of them also in the palette. */
import { type RefObject, useEffect } from "react";

import { useStudio } from "../model/studio";
import { currentDrawing } from "./drawing";
import { openContextMenu } from "./context";
import { deleteSelection, duplicateSelection, openWrapping, unwrapSelection } from "./edits";
import { toggleFoldOfSelection } from "./folded";
import { openNote } from "./Notes";
import { toggleFollowing, toggleMinimap, useView } from "./view";
import { type Step, walk } from "./walk";

const STEPS: Record<string, Step> = { ArrowUp: "up", ArrowDown: "down", ArrowLeft: "left", ArrowRight: "right" };

function step(direction: Step): boolean {
  const drawing = currentDrawing();
  const { selection, select } = useStudio.getState();
  const next = drawing === null ? null : walk(drawing, selection.at(-1) ?? null, direction);
  if (next !== null) select([next]);
  return true;
}

/** Every vertex that stands in a chain; what is inside them goes along. */
export function selectAll(): void {
  const nodes = currentDrawing()?.layout.nodes.filter((node) => node.block !== null && node.kind !== "barEnd") ?? [];
  useStudio.getState().select(nodes.map((node) => node.vertex));
}

/** Enter goes to the first thing that can be set on the selected vertex. */
export function editSelected(): boolean {
  const field = document.querySelector<HTMLElement>("[data-inspector-field]");
  field?.focus();
  return field !== null;
}

function escape(): boolean {
  const { arc, adding } = useView.getState();
  if (adding === null && arc === null && useStudio.getState().selection.length === 0) return false;
  useView.setState({ arc: null, adding: null });
  useStudio.getState().select([]);
  return true;
}

export function openAdding(): boolean {
  useView.getState().setAdding({ vertex: useStudio.getState().selection.at(-1) ?? null, slot: null });
  return true;
}

/** Does what a key means; says whether it meant anything. */
function press(event: KeyboardEvent): boolean {
  const { undo, redo } = useStudio.getState();
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (event.ctrlKey || event.metaKey) {
    if (key === "z") (event.shiftKey ? redo : undo)();
    else if (key === "y") redo();
    else if (key === "d") duplicateSelection();
    else if (key === "a") selectAll();
    else if (key === "0") useView.getState().viewport?.home();
    else return false;
    return true;
  }
  const direction = STEPS[key];
  if (direction !== undefined && !event.altKey) return step(direction);
  if (key === "ContextMenu" || (key === "F10" && event.shiftKey)) return openContextMenu();
  if (key === "w" && !event.altKey) return event.shiftKey ? unwrapSelection() : openWrapping();
  if (key === "c" && !event.altKey && !event.shiftKey) return toggleFoldOfSelection();
  if (key === "n" && !event.altKey && !event.shiftKey) return openNote();
  if (key === "/") return openAdding();
  if (key === "Delete" || key === "Backspace") return deleteSelection();
  if (key === "Escape") return escape();
  if (key === "Enter") return editSelected();
  const plain = !event.altKey && !event.shiftKey;
  if (key === "z" && plain) useView.getState().viewport?.zoomToSelection();
  else if (key === "m" && plain) toggleMinimap();
  else if (key === "f" && plain) toggleFollowing();
  else if (key === "+" || key === "=") useView.getState().viewport?.zoomIn();
  else if (key === "-") useView.getState().viewport?.zoomOut();
  else return false;
  return true;
}

export function useCanvasKeys(root: RefObject<HTMLDivElement | null>): void {
  useEffect(() => {
    const onKey = (event: KeyboardEvent) => {
      const target = event.target instanceof Element ? event.target : document.body;
      if (event.defaultPrevented || target.closest("input, textarea, select, [contenteditable=true], [role=dialog]"))
        return;
      const inPalette = target.closest("[role=tree]") !== null;
      if (target !== document.body && !inPalette && root.current?.contains(target) !== true) return;
      // The tree of parts walks and adds by the same keys.
      if (inPalette && !event.ctrlKey && !event.metaKey && event.key !== "Delete" && event.key !== "Backspace") return;
      // A focused button of the canvas keeps its own Enter.
      if (event.key === "Enter" && target.closest("button") !== null) return;
      if (press(event)) event.preventDefault();
    };
    window.addEventListener("keydown", onKey, true);
    return () => {
      window.removeEventListener("keydown", onKey, true);
    };
  }, [root]);
}
