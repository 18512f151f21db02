/** A table in which keys walk from cell to cell: one cell is in the order of Tab, and Enter or a press chooses one. */
import { type FocusEvent, type KeyboardEvent, type MouseEvent, type RefObject, useRef, useState } from "react";

import { mirrored } from "../i18n/language";
import { type Cell, walkGrid } from "./grid";

interface GridWalk {
  /** The cell that the keys are at. */
  at: Cell;
  /** For the table, whose cells have `data-cell={cellName(...)}`. */
  table: {
    ref: RefObject<HTMLTableElement | null>;
    onKeyDown: (event: KeyboardEvent) => void;
    onFocus: (event: FocusEvent) => void;
    onClick: (event: MouseEvent) => void;
  };
}

export function cellName({ row, column }: Cell): string {
  return `${String(row)} ${String(column)}`;
}

function cellOf(target: EventTarget): Cell | null {
  const name = target instanceof Element ? target.closest<HTMLElement>("[data-cell]")?.dataset["cell"] : undefined;
  if (name === undefined) return null;
  const [row = 0, column = 0] = name.split(" ").map(Number);
  return { row, column };
}

/** `size`: how many rows and columns there are. */
export function useGridWalk(size: Cell, choose: (cell: Cell) => void): GridWalk {
  const [at, setAt] = useState<Cell>({ row: 0, column: 0 });
  const ref = useRef<HTMLTableElement>(null);
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const enter = event.key === "Enter" || event.key === " ";
    const to = walkGrid(event.key, at, size, mirrored() ? "ArrowLeft" : "ArrowRight");
    if (!enter && to === null) return;
    event.preventDefault();
    event.stopPropagation();
    if (to !== null) ref.current?.querySelector<HTMLElement>(`[data-cell="${cellName(to)}"]`)?.focus();
    else choose(at);
  };
  const onFocus = (event: FocusEvent) => {
    const cell = cellOf(event.target);
    if (cell !== null) setAt(cell);
  };
  const onClick = (event: MouseEvent) => {
    const cell = cellOf(event.target);
    if (cell !== null) choose(cell);
  };
  return { at, table: { ref, onKeyDown, onFocus, onClick } };
}
