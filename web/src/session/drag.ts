/**
 * Dragging of parts and vertices with any pointer: mouse, finger, pen.
 *
 * A drag begins when a pressed pointer has moved a little; from then on a ghost follows it and the canvas says (by its
 * resolver) where a drop would go. Over the bin, which the list of parts is, vertices are thrown away. Escape or a lost
 * pointer ends it without a change (`ui/pointer-drag`).
 */
import type { PointerEvent as ReactPointerEvent } from "react";
import { create } from "zustand";

import type { Point } from "../model/layout";
import { followPointer } from "../ui/pointer-drag";
import { addPartAt, deleteVertices, movePartsTo } from "./edits";
import type { Target } from "./targets";
import { useView } from "./view";

export type Payload = { kind: "part"; element: string } | { kind: "vertices"; ids: string[]; element: string };

interface DragState {
  payload: Payload | null;
  /** In px of the window. */
  at: Point;
  target: Target | null;
  /** Whether a drop throws it away. */
  away: boolean;
  /** Alt: a copy is dropped. */
  copy: boolean;
}

type Resolver = (at: Point, payload: Payload) => Target | null;

const NOWHERE = { target: null, away: false, copy: false };

export const useDrag = create<DragState>(() => ({ payload: null, at: { x: 0, y: 0 }, ...NOWHERE }));

let resolver: Resolver = () => null;
let bin: Element | null = null;
let ended = false;
let cancelCurrent: () => void = () => undefined;

// The click of the release follows at once; whatever else is pressed next means what it says.
for (const name of ["pointerdown", "keydown"]) window.addEventListener(name, () => (ended = false), true);
window.addEventListener("click", () => setTimeout(() => (ended = false)), true);

/** The canvas says where things go. */
export function setResolver(resolve: Resolver): void {
  resolver = resolve;
}

/** What throws away the vertices that are dropped on it; null for nothing. */
export function setBin(element: Element | null): void {
  bin = element;
}

function isOverBin({ x, y }: Point, { kind }: Payload): boolean {
  const box = bin?.getBoundingClientRect();
  if (box === undefined || box.width === 0 || kind === "part") return false;
  return x >= box.left && x <= box.right && y >= box.top && y <= box.bottom;
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
      const away = isOverBin(at, payload);
      const found = away ? null : resolver(at, payload);
      const { target } = useDrag.getState();
      useDrag.setState({ payload, at, copy, away, target: found?.key === target?.key ? target : found });
    },
    drop: () => {
      const { target, copy, away } = useDrag.getState();
      useDrag.setState({ payload: null, ...NOWHERE });
      if (away && payload.kind === "vertices") throwAway(payload.ids);
      else if (target !== null) drop(payload, target, copy);
    },
    end: (moved) => {
      if (moved) ended = true;
      useDrag.setState({ payload: null, ...NOWHERE });
    },
  });
}

function throwAway(ids: string[]): void {
  deleteVertices(ids);
  useView.getState().viewport?.focus();
}

function drop(payload: Payload, { place }: Target, copy: boolean): void {
  if (payload.kind === "part") addPartAt(place, payload.element);
  else movePartsTo(place, payload.ids, copy);
  useView.getState().viewport?.focus();
}
