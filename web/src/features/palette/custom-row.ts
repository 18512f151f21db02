/** What the row of a part of one's own does in the palette besides adding it: by right button, keys and a resting finger. */
import type { MouseEvent, PointerEvent } from "react";

import { openDelete, openEdit, openPartMenu } from "../../session/custom-blocks";
import { cancelDrag } from "../../session/drag";
import { whenFingerRests } from "../../ui/rest";

/** Handlers for the row. */
export function ownHandlers(name: string) {
  return {
    onContextMenu: (event: MouseEvent) => {
      event.preventDefault();
      openPartMenu(name, event.clientX, event.clientY);
    },
  };
}

/** Opens the menu under a finger that rests. */
export function restOnOwn(event: PointerEvent, name: string): void {
  whenFingerRests(event, (x, y) => {
    cancelDrag();
    openPartMenu(name, x, y);
  });
}

/** What a key means on the row; false when it means nothing there. */
export function ownKey(event: { key: string; shiftKey: boolean }, name: string): boolean {
  const isMenu = event.key === "ContextMenu" || (event.key === "F10" && event.shiftKey);
  if (event.key === "F2") openEdit(name);
  else if (event.key === "Delete" || event.key === "Backspace") openDelete(name);
  else if (isMenu) {
    const box = document.activeElement?.getBoundingClientRect();
    openPartMenu(name, (box?.left ?? 0) + 24, box?.bottom ?? 0);
  } else return false;
  return true;
}
