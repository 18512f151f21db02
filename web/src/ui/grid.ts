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

// Cards that stand in rows.

interface Place {
  left: number;
  top: number;
}

/** Of cards in one row the tops differ by less. */
const ROW_PX = 8;

/**
 * Where a key leads from a card: the place of another one, -1 for what stands above the first row, null where the key is
 * not for cards or there is none in that direction.
 */
export function nextCard(key: string, at: number, places: readonly Place[], rightToLeft: boolean): number | null {
  const here = places[at];
  if (here === undefined) return null;
  if (key === "Home") return 0;
  if (key === "End") return places.length - 1;
  const ahead = rightToLeft ? "ArrowLeft" : "ArrowRight";
  if (key === "ArrowLeft" || key === "ArrowRight") {
    const to = at + (key === ahead ? 1 : -1);
    return to >= 0 && to < places.length ? to : null;
  }
  if (key !== "ArrowUp" && key !== "ArrowDown") return null;
  const way = key === "ArrowDown" ? 1 : -1;
  const beyond = places
    .map((place, index) => ({ index, away: (place.top - here.top) * way, aside: Math.abs(place.left - here.left) }))
    .filter(({ away }) => away > ROW_PX);
  const nearest = Math.min(...beyond.map(({ away }) => away));
  const row = beyond.filter(({ away }) => away < nearest + ROW_PX);
  row.sort((a, b) => a.aside - b.aside);
  return row[0]?.index ?? (way < 0 ? -1 : null);
}
