/** What a variable's row of the palette does besides folding: by double click, right button and a finger that rests. */
import type { MouseEvent, PointerEvent } from "react";

import { type Named, renameVariable, useVariables } from "./variables";

const REST_MS = 550;
const STILL_PX = 8;

/** Handlers for the row. */
export function variableHandlers(of: Named) {
  const open = (x: number, y: number) => useVariables.setState({ menu: { ...of, x, y } });
  return {
    // The graph leaves Delete to it.
    "data-removable": true,
    onDoubleClick: () => renameVariable(of),
    onContextMenu: (event: MouseEvent) => {
      event.preventDefault();
      open(event.clientX, event.clientY);
    },
    onPointerDown: (event: PointerEvent) => {
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
    },
  };
}
