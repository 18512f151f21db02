/** The part of the graph that is drawn: what can be seen, in whole tiles, so that panning draws anew only now and then. */
import { useMemo } from "react";

import { useCameraState } from "./camera";

export interface Part {
  x0: number;
  y0: number;
  x1: number;
  y1: number;
}

const TILE = 512;
/** From far away. */
const PLAIN_TILE = 4096;

export function usePart(plain: boolean): Part {
  const size = plain ? PLAIN_TILE : TILE;
  const tiles = useCameraState(({ x, y, zoom, width, height }) => {
    const tile = (value: number) => Math.floor(value / zoom / size);
    return [tile(-x) - 1, tile(-y) - 1, tile(width - x) + 2, tile(height - y) + 2].join(" ");
  });
  return useMemo(() => {
    const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = tiles.split(" ").map((tile) => Number(tile) * size);
    return { x0, y0, x1, y1 };
  }, [tiles, size]);
}

export function boxInside({ x, y, w, h }: { x: number; y: number; w: number; h: number }, part: Part): boolean {
  return x < part.x1 && x + w > part.x0 && y < part.y1 && y + h > part.y0;
}
