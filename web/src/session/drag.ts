/**
 * Dragging of parts and vertices with any pointer: mouse, finger, pen.
 *
 * A drag begins when a pressed pointer has moved a little; from then on a ghost follows it and the canvas says (by its
 * resolver) where a drop would go. Escape or a lost pointer ends it without a change (`ui/pointer-drag`).
 */
import type { PointerEvent as ReactPointerEvent } from "react";
import { create } from "zustand";

import type { Point } from "../model/layout";
import { followPointer } from "../ui/pointer-drag";
import { addPartAt, movePartsTo } from "./edits";
import type { Target } from "./targets";
import { useView } from "./view";

export type Payload = { kind: "part"; element: string } | { kind: "vertices"; ids: string[]; element: string };

interface DragState {
  payload: Payload | null;
  /** In px of the window. */
  at: Point;
  target: Target | null;
  /** Alt: a copy is dropped. */
  copy: boolean;
}

type Resolver = (at: Point, payload: Payload) => Target | null;

export const useDrag = create<DragState>(() => ({ payload: null, at: { x: 0, y: 0 }, target: null, copy: false }));

let resolver: Resolver = () => null;
let ended = false;
let cancelCurrent: () => void = () => undefined;

// The click of the release follows at once; whatever else is pressed next means what it says.
for (const name of ["pointerdown", "keydown"]) window.addEventListener(name, () => (ended = false), true);
window.addEventListener("click", () => setTimeout(() => (ended = false)), true);

/** The canvas says where things go. */
export function setResolver(resolve: Resolver): void {
  resolver = resolve;
}

/** Looks again where a drop would go, after the graph has moved under the pointer. */
export function retarget(): void {
  const { payload, at, target } = useDrag.getState();
  const found = payload === null ? null : resolver(at, payload);
  if (found?.key !== target?.key) useDrag.setState({ target: found });
}

/** Whether a drag has just ended, so that the click that follows it means nothing. */
export function justDragged(): boolean {
  return ended;
}

/** Ends a drag that is on, or about to be, without a change. */
export function cancelDrag(): void {
  cancelCurrent();
}

/** From a pointer that went down on something that can be dragged. */
export function beginDrag(event: ReactPointerEvent, payload: Payload): void {
  // A second finger begins no drag, and leaves that of the first to be ended.
  if (!event.isPrimary) return;
  cancelCurrent = followPointer(event, {
    move: (at, copy) => {
      const found = resolver(at, payload);
      const { target } = useDrag.getState();
      useDrag.setState({ payload, at, copy, target: found?.key === target?.key ? target : found });
    },
    drop: () => {
      const { target, copy } = useDrag.getState();
      useDrag.setState({ payload: null, target: null, copy: false });
      if (target !== null) drop(payload, target, copy);
    },
    end: (moved) => {
      if (moved) ended = true;
      useDrag.setState({ payload: null, target: null, copy: false });
    },
  });
}

function drop(payload: Payload, { place }: Target, copy: boolean): void {
  if (payload.kind === "part") addPartAt(place, payload.element);
  else movePartsTo(place, payload.ids, copy);
  useView.getState().viewport?.focus();
}
