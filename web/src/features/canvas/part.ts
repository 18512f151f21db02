/** The part of the graph that is drawn: what can be seen, in whole tiles, so that panning draws anew only now and then. */
import { useShallow } from "zustand/react/shallow";

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
  return useCameraState(
    useShallow(({ x, y, zoom, width, height }): Part => {
      const tile = (value: number, more: number) => (Math.floor(value / zoom / size) + more) * size;
      return { x0: tile(-x, -1), y0: tile(-y, -1), x1: tile(width - x, 2), y1: tile(height - y, 2) };
    }),
  );
}

export function boxInside({ x, y, w, h }: { x: number; y: number; w: number; h: number }, part: Part): boolean {
  return x < part.x1 && x + w > part.x0 && y < part.y1 && y + h > part.y0;
}
