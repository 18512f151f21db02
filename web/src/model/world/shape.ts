/** The outlines of what lies around its middle: boxes, balls, and zones, which are circles or rectangles. */
import type { OwnWorld } from "../types";
import { type Part, partOf } from "./part-reference";

/** A circle where `radius` is more than 0, else a rectangle; in mm. */
export interface Shape {
  x: number;
  y: number;
  radius: number;
  width: number;
  height: number;
}

export type Middled = "box" | "ball" | "zone";

export function shapeOf(world: OwnWorld, { kind, at }: { kind: Middled; at: number }): Shape | null {
  const part: Part<Middled> | undefined = partOf(world, { kind, at });
  if (part === undefined) return null;
  const radius = "radius_mm" in part ? part.radius_mm : 0;
  const [width, height] = "width_mm" in part ? [part.width_mm, part.height_mm] : [0, 0];
  return { x: part.x_mm, y: part.y_mm, radius, width, height };
}

/** How far a place is from a shape, 0 inside. */
export function offShape(shape: Shape, x: number, y: number): number {
  const [dx, dy] = [Math.abs(x - shape.x), Math.abs(y - shape.y)];
  if (shape.radius > 0) return Math.max(Math.hypot(dx, dy) - shape.radius, 0);
  return Math.hypot(Math.max(dx - shape.width / 2, 0), Math.max(dy - shape.height / 2, 0));
}
