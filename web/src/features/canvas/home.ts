/** Where the canvas looks at first: all of a program as large as can be read, else its Start. Pure: px of the canvas. */
import type { Drawing } from "../../session/drawing";
import type { Camera, Size } from "./camera";

/** What of a drawing places the camera. */
type Drawn = Pick<Drawing, "layout" | "nodes">;

const START_AT = 40;
const EMPTY_START_AT = 116;
const LOW = 900;
const SIDE = 16;
/** What the zoom control covers. */
const BOTTOM = 64;
/** Letters of 14 px are then 10 px. */
export const LEAST_READABLE = 0.7;

/** On a low window the cards of an empty program need the room above it. */
function startAt({ height }: Size, { nodes }: Drawn): number {
  return nodes.has("place") && height >= LOW ? EMPTY_START_AT : START_AT;
}

/** Start on top and in the middle, except where that cuts off a side of a program that fits. */
export function homeOf(size: Size, drawing: Drawn, zoom = 1): Camera {
  const { x, y, w } = drawing.layout.bounds;
  const middle = size.width / 2;
  const fits = size.width >= w * zoom + 2 * SIDE;
  const most = size.width - SIDE - (x + w) * zoom;
  return {
    x: Math.round(fits ? Math.min(Math.max(middle, SIDE - x * zoom), most) : middle),
    // What is above the middle of Start is as far from the edge at every zoom.
    y: startAt(size, drawing) + y * (1 - zoom),
    zoom,
  };
}

/** A camera that shows all of a program, and how small it may be: `wholeOf`. */
export interface Whole {
  camera: Camera;
  least: number;
}

function isAt(one: Camera, other: Camera): boolean {
  return Math.abs(one.x - other.x) < 1 && Math.abs(one.y - other.y) < 1 && Math.abs(one.zoom - other.zoom) < 0.001;
}

/**
 * The camera once a canvas of `width` px is as large as `size`: one that still showed the whole program shows it again, one
 * that was moved keeps what was in the middle there.
 */
export function afterResize(
  camera: Camera,
  width: number,
  size: Size,
  drawing: Drawn,
  whole: Whole | null,
): { camera: Camera; whole: Whole | null } {
  if (whole === null || !isAt(camera, whole.camera))
    return { camera: { ...camera, x: camera.x + (size.width - width) / 2 }, whole: null };
  const now = wholeOf(size, drawing, whole.least);
  return { camera: now, whole: { camera: now, least: whole.least } };
}

/** All of a program from its Start, not larger than 1; one that does not fit at `least` as wide as fits, from its Start. */
export function wholeOf(size: Size, drawing: Drawn, least: number): Camera {
  const { y, w, h } = drawing.layout.bounds;
  const across = (size.width - 2 * SIDE) / w;
  const down = (size.height - startAt(size, drawing) - y - BOTTOM) / h;
  const all = Math.min(across, down);
  const zoom = all >= least ? all : Math.max(across, least);
  return homeOf(size, drawing, Math.min(1, zoom));
}
