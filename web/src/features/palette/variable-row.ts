/** What a variable's row of the palette does: by double click, right button and a finger that rests. */
import type { MouseEvent, PointerEvent } from "react";

import { type Named, openVariableMenu, renameVariable } from "../../session/variables";
import { whenFingerRests } from "../../ui/rest";

/** Handlers for the row. */
export function variableHandlers(of: Named) {
  const open = (x: number, y: number) => openVariableMenu({ ...of, x, y });
  return {
    // The graph leaves Delete to it.
    "data-removable": true,
    onDoubleClick: () => renameVariable(of),
    onContextMenu: (event: MouseEvent) => {
      event.preventDefault();
      open(event.clientX, event.clientY);
    },
    onPointerDown: (event: PointerEvent) => whenFingerRests(event, open),
  };
}
