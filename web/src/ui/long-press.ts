/** A finger that rests asks for the menu, as the right button does. */
import type { PointerEvent } from "react";

const REST_MS = 550;
const STILL_PX = 8;

/** From a pointer that went down: calls back where a finger stays for a while without moving; a mouse never does. */
export function onLongPress(event: PointerEvent, open: (x: number, y: number) => void): void {
  if (event.pointerType === "mouse") return;
  const { clientX: x, clientY: y } = event;
  const timer = setTimeout(() => {
    end();
    open(x, y);
  }, REST_MS);
  const moved = (move: globalThis.PointerEvent) => {
    if (Math.hypot(move.clientX - x, move.clientY - y) > STILL_PX) end();
  };
  const end = () => {
    clearTimeout(timer);
    window.removeEventListener("pointermove", moved);
    window.removeEventListener("pointerup", end);
    window.removeEventListener("pointercancel", end);
  };
  window.addEventListener("pointermove", moved);
  window.addEventListener("pointerup", end);
  window.addEventListener("pointercancel", end);
}
