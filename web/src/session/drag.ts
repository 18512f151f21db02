/**
 * Dragging of parts and vertices with any pointer: mouse, finger, pen.
 *
 * A drag begins when a pressed pointer has moved a little; from then on a ghost follows it and the canvas says (by its
 * resolver) where a drop would go. Escape or a lost pointer ends it without a change. A finger that rests a moment on a
 * part drags it in any direction; one that moves at once up or down scrolls what can be scrolled.
 */
import type { PointerEvent as ReactPointerEvent } from "react";
import { create } from "zustand";

import type { Point } from "../model/layout";
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

const FAR_ENOUGH = 5;
const HOLD_MS = 180;

let resolver: Resolver = () => null;
let ended = false;
let cancelCurrent: () => void = () => undefined;

/** Once it drags, a finger does not scroll. Browsers want to know of this before the finger goes down. */
window.addEventListener(
  "touchmove",
  (event) => {
    if (useDrag.getState().payload !== null && event.cancelable) event.preventDefault();
  },
  { passive: false },
);

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
  if (event.button !== 0 || !event.isPrimary) return;
  const from = { x: event.clientX, y: event.clientY };
  const pointer = event.pointerId;
  let active = false;

  const show = (at: Point, copy: boolean) => {
    active = true;
    const found = resolver(at, payload);
    const { target } = useDrag.getState();
    useDrag.setState({ payload, at, copy, target: found?.key === target?.key ? target : found });
  };
  const hold = event.pointerType === "touch" ? setTimeout(() => show(from, false), HOLD_MS) : undefined;
  const move = (next: PointerEvent) => {
    if (next.pointerId !== pointer) return;
    const at = { x: next.clientX, y: next.clientY };
    if (!active && Math.hypot(at.x - from.x, at.y - from.y) < FAR_ENOUGH) return;
    next.preventDefault();
    show(at, next.altKey);
  };
  const up = (next: PointerEvent) => {
    if (next.pointerId !== pointer) return;
    if (active) move(next);
    const { target, copy } = useDrag.getState();
    finish();
    if (active && target !== null) drop(payload, target, copy);
  };
  const cancel = (next: PointerEvent) => {
    if (next.pointerId === pointer) finish();
  };
  const key = (next: KeyboardEvent) => {
    if (next.key === "Alt") useDrag.setState({ copy: next.type === "keydown" });
    if (!active || next.key !== "Escape") return;
    next.preventDefault();
    next.stopPropagation();
    finish();
  };
  const finish = () => {
    cancelCurrent = () => undefined;
    clearTimeout(hold);
    window.removeEventListener("pointermove", move);
    window.removeEventListener("pointerup", up);
    window.removeEventListener("pointercancel", cancel);
    window.removeEventListener("keydown", key, true);
    window.removeEventListener("keyup", key, true);
    if (active) ended = true;
    useDrag.setState({ payload: null, target: null, copy: false });
  };

  cancelCurrent = finish;
  window.addEventListener("pointermove", move);
  window.addEventListener("pointerup", up);
  window.addEventListener("pointercancel", cancel);
  window.addEventListener("keydown", key, true);
  window.addEventListener("keyup", key, true);
}

function drop(payload: Payload, { place }: Target, copy: boolean): void {
  if (payload.kind === "part") addPartAt(place, payload.element);
  else movePartsTo(place, payload.ids, copy);
  useView.getState().viewport?.focus();
}
