/**
 * From the world to the screen: mm with y up → CSS px with y down.
 *
 * `scale` is px a mm; `x`, `y` is where the world's origin lies on the screen.
 */
export interface Camera {
  scale: number;
  x: number;
  y: number;
}

export interface Box {
  left: number;
  right: number;
  bottom: number;
  top: number;
}

export interface Room {
  width: number;
  height: number;
}

const CLOSEST = 8;
const FURTHEST = 0.25;

/** The largest scale that a world opens with, in px a mm: a usual robot is then 270 px long. */
const LARGEST = 2;

/** Shows the whole of a world, in the middle, with a margin in px. */
export function fit(world: { width_mm: number; height_mm: number }, room: Room, margin: number): Camera {
  return fitBox({ left: 0, right: world.width_mm, bottom: 0, top: world.height_mm }, room, margin);
}

/** Shows the whole of a box of the world, in the middle, with a margin in px. */
export function fitBox({ left, right, bottom, top }: Box, room: Room, margin: number): Camera {
  const width = Math.max(right - left, 1);
  const height = Math.max(top - bottom, 1);
  const fitting = Math.min((room.width - 2 * margin) / width, (room.height - 2 * margin) / height, LARGEST);
  const scale = Math.max(fitting, 1e-3);
  return { scale, x: room.width / 2 - ((left + right) / 2) * scale, y: room.height / 2 + ((bottom + top) / 2) * scale };
}

export function toScreen(camera: Camera, x_mm: number, y_mm: number): [number, number] {
  return [camera.x + x_mm * camera.scale, camera.y - y_mm * camera.scale];
}

export function toWorld(camera: Camera, x: number, y: number): [number, number] {
  return [(x - camera.x) / camera.scale, (camera.y - y) / camera.scale];
}

/** Closer or further by `factor`, with the point under the hand held still; `whole` is the fitted camera. */
export function zoomAt(camera: Camera, whole: Camera, factor: number, x: number, y: number): Camera {
  const scale = Math.min(Math.max(camera.scale * factor, whole.scale * FURTHEST), whole.scale * CLOSEST);
  const real = scale / camera.scale;
  return { scale, x: x + (camera.x - x) * real, y: y + (camera.y - y) * real };
}
