/** How small and how large the graph can be shown. */
export const LEAST_ZOOM = 0.1;
export const MOST_ZOOM = 2;
/** A program may be shown so small that it fits so many pixels. */
const SMALL_WINDOW = 400;

/** How small a program of this size can be shown: a long one as small as fitting it into a small window takes. */
export function leastZoom({ w, h }: { w: number; h: number }): number {
  return Math.min(LEAST_ZOOM, SMALL_WINDOW / Math.max(w, h, 1));
}
