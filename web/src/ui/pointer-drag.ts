/**
 * A drag of a pointer that went down: mouse, finger or pen.
 *
 * It begins when the pointer has moved a little, and ends without a drop by Escape or when the pointer is lost. A finger on
 * what scrolls, by its CSS `touch-action`, scrolls: it drags after it has rested a moment, or where it moves across.
 */
import type { PointerEvent as ReactPointerEvent } from "react";

import { endAll, listen } from "./effects";

interface Place {
  x: number;
  y: number;
}

export interface PointerDrag {
  /** Where the pointer is now, in px of the window, and whether Alt is held. */
  move: (at: Place, alt: boolean) => void;
  drop: (at: Place) => void;
  /** In any case, after `drop`; `moved`: whether it was a drag at all. */
  end?: (moved: boolean) => void;
}

const FAR_ENOUGH = 5;
const HOLD_MS = 250;

let dragging = false;

/** Once it drags, a finger does not scroll. Browsers want to know of this before the finger goes down. */
window.addEventListener(
  "touchmove",
  (event) => {
    if (dragging && event.cancelable) event.preventDefault();
  },
  { passive: false },
);

/** Whether a finger that moves so far over an element scrolls what is around it. */
export function scrollsUnder(element: Element | null, dx: number, dy: number): boolean {
  const action = element === null ? "none" : getComputedStyle(element).touchAction;
  if (action === "none" || element === null) return false;
  const across = Math.abs(dx) > Math.abs(dy);
  if (action === "pan-y") return !across && scrollsUnder(element.parentElement, dx, dy);
  if (action === "pan-x") return across && scrollsUnder(element.parentElement, dx, dy);
  return element.parentElement === null || scrollsUnder(element.parentElement, dx, dy);
}

/** Follows the pointer of a `pointerdown`; gives what ends it without a drop. */
export function followPointer(event: ReactPointerEvent, { move, drop, end }: PointerDrag): () => void {
  if (event.button !== 0 || !event.isPrimary) return () => undefined;
  const from = { x: event.clientX, y: event.clientY };
  const { pointerId, pointerType, currentTarget: target } = event;
  let at: Place = from;
  let active = false;

  const show = (to: Place, alt: boolean) => {
    active = dragging = true;
    at = to;
    move(to, alt);
  };
  const hold = pointerType === "touch" ? setTimeout(() => show(from, false), HOLD_MS) : undefined;
  const moved = (next: PointerEvent) => {
    if (next.pointerId !== pointerId) return;
    const [dx, dy] = [next.clientX - from.x, next.clientY - from.y];
    if (!active && Math.hypot(dx, dy) < FAR_ENOUGH) return;
    if (!active && pointerType === "touch" && scrollsUnder(target, dx, dy)) {
      finish();
      return;
    }
    next.preventDefault();
    show({ x: next.clientX, y: next.clientY }, next.altKey);
  };
  const up = (next: PointerEvent) => {
    if (next.pointerId !== pointerId) return;
    if (active) {
      moved(next);
      drop(at);
    }
    finish();
  };
  const lost = (next: PointerEvent) => {
    if (next.pointerId === pointerId) finish();
  };
  const key = (next: KeyboardEvent) => {
    if (!active) return;
    if (next.key === "Alt") move(at, next.type === "keydown");
    if (next.key !== "Escape") return;
    next.preventDefault();
    next.stopPropagation();
    finish();
  };
  let over = false;
  const finish = () => {
    if (over) return;
    over = true;
    dragging = false;
    clearTimeout(hold);
    endListening();
    end?.(active);
  };
  const endListening = endAll(
    listen(window, { pointermove: moved, pointerup: up, pointercancel: lost }),
    listen(window, { keydown: key, keyup: key }, { capture: true }),
  );
  return finish;
}
