/** What can be done with a row of the palette besides adding it: by keys, the right button and a finger that rests. */
import type { MouseEvent } from "react";

import { isOwn, openDelete, openEdit, openPartMenu } from "../../session/custom-blocks";
import { cancelDrag } from "../../session/drag";
import { openVariableMenu, renameVariable, takeAway } from "../../session/variables";
import type { Row } from "./tree";

export interface RowActions {
  change: () => void;
  remove: () => void;
  /** At a place of the window. */
  openMenu: (x: number, y: number) => void;
}

/** Those of a part of one's own and of a variable; null for any other row. */
export function actionsOf(row: Row, robot: string): RowActions | null {
  if (row.kind === "object" && row.object.category === "variable") {
    const of = { robot, name: row.object.name };
    return {
      change: () => renameVariable(of),
      remove: () => takeAway(of),
      openMenu: (x, y) => openVariableMenu({ ...of, x, y }),
    };
  }
  if (row.kind !== "part" || !isOwn(row.shape)) return null;
  const { element } = row.shape;
  return {
    change: () => openEdit(element),
    remove: () => openDelete(element),
    openMenu: (x, y) => {
      cancelDrag();
      openPartMenu(element, x, y);
    },
  };
}

/** Handlers of the row's element. The graph leaves Delete to it. */
export function removableProps({ openMenu }: RowActions) {
  return {
    "data-removable": true,
    onContextMenu: (event: MouseEvent) => {
      event.preventDefault();
      openMenu(event.clientX, event.clientY);
    },
  };
}

/** What a key means on the row that has the focus; false when it means nothing there. */
export function rowKey(event: { key: string; shiftKey: boolean }, { change, remove, openMenu }: RowActions): boolean {
  const box = document.activeElement?.getBoundingClientRect();
  if (event.key === "F2") change();
  else if (event.key === "Delete" || event.key === "Backspace") remove();
  else if (event.key === "ContextMenu" || (event.key === "F10" && event.shiftKey))
    openMenu((box?.left ?? 0) + 24, box?.bottom ?? 0);
  else return false;
  return true;
}
