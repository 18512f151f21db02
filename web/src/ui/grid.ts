/** How keys walk in a grid of cells. */

export interface Cell {
  row: number;
  column: number;
}

/** Where a key leads from a cell, or null; `forward` is the arrow that points along a line of writing. */
export function walkGrid(
  key: string,
  { row, column }: Cell,
  size: Cell,
  forward: "ArrowRight" | "ArrowLeft",
): Cell | null {
  const back = forward === "ArrowRight" ? "ArrowLeft" : "ArrowRight";
  const steps: Record<string, Cell> = {
    [forward]: { row, column: column + 1 },
    [back]: { row, column: column - 1 },
    ArrowDown: { row: row + 1, column },
    ArrowUp: { row: row - 1, column },
    Home: { row, column: 0 },
    End: { row, column: size.column - 1 },
    PageUp: { row: 0, column },
    PageDown: { row: size.row - 1, column },
  };
  const to = steps[key];
  if (to === undefined) return null;
  const within = (value: number, count: number) => Math.min(Math.max(value, 0), count - 1);
  return { row: within(to.row, size.row), column: within(to.column, size.column) };
}
