/** Places along a road and in a world. Lengths in mm, angles in radians, y up. */
import type { Road, Storehouse } from "../../api/wire";
import type { World } from "../../model/types";
import type { Box } from "./camera";

/** The length of most robots, which is drawn at 54 units. */
export const ROBOT_MM = 135;

export interface Place {
  x: number;
  y: number;
  /** The direction of the road there. */
  heading: number;
}

type Point = readonly [number, number];
/** What a road and a line on the floor have in common. */
type Course = Pick<Road, "closed" | "points">;

/** The corners of the line, with the first one again at the end of a closed road. */
export function lineOf(road: Course): readonly Point[] {
  const first = road.points[0];
  const last = road.points.at(-1);
  if (!road.closed || first === undefined || last === undefined) return road.points;
  return first[0] === last[0] && first[1] === last[1] ? road.points : [...road.points, first];
}

export function roadLength(road: Road): number {
  const line = lineOf(road);
  let length = 0;
  for (let i = 1; i < line.length; i++) length += distance(line[i - 1], line[i]);
  return length;
}

function distance(a: Point | undefined, b: Point | undefined): number {
  return a === undefined || b === undefined ? 0 : Math.hypot(b[0] - a[0], b[1] - a[1]);
}

/** The place so many mm along; wraps on a closed road, stays at the ends of an open one. */
export function placeAlong(road: Road, at_mm: number): Place | null {
  const line = lineOf(road);
  const length = roadLength(road);
  if (line.length < 2 || length === 0) return null;
  let left = road.closed ? ((at_mm % length) + length) % length : Math.min(Math.max(at_mm, 0), length);
  for (let i = 1; i < line.length; i++) {
    const from = line[i - 1];
    const to = line[i];
    if (from === undefined || to === undefined) continue;
    const piece = distance(from, to);
    if (left <= piece && piece > 0) {
      const share = left / piece;
      return {
        x: from[0] + (to[0] - from[0]) * share,
        y: from[1] + (to[1] - from[1]) * share,
        heading: Math.atan2(to[1] - from[1], to[0] - from[0]),
      };
    }
    left -= piece;
  }
  return null;
}

/** How far along the road the nearest point of it lies, and how far off that is. */
export function nearestOn(road: Course, x: number, y: number): { along: number; off: number } {
  const line = lineOf(road);
  let best = { along: 0, off: Infinity };
  let passed = 0;
  for (let i = 1; i < line.length; i++) {
    const from = line[i - 1];
    const to = line[i];
    if (from === undefined || to === undefined) continue;
    const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    const piece = Math.hypot(dx, dy);
    if (piece === 0) continue;
    const share = Math.min(Math.max(((x - from[0]) * dx + (y - from[1]) * dy) / (piece * piece), 0), 1);
    const off = Math.hypot(x - from[0] - dx * share, y - from[1] - dy * share);
    if (off < best.off) best = { along: passed + piece * share, off };
    passed += piece;
  }
  return best;
}

/** The sign of the section that a place lies in; null off the roads. */
export function signAt(world: World, x: number, y: number): number | null {
  for (const road of world.roads) {
    if (road.sections.length === 0) continue;
    const { along, off } = nearestOn(road, x, y);
    if (off > road.width_mm / 2) continue;
    const found = road.sections.find((section) => along >= section.from_mm && along < section.to_mm);
    return (found ?? road.sections.at(-1))?.sign ?? null;
  }
  return null;
}

/** Whether a place is in a storehouse. */
export function isIn({ x_mm, y_mm, width_mm, height_mm }: Storehouse, at: { x_mm: number; y_mm: number }): boolean {
  return at.x_mm >= x_mm && at.x_mm <= x_mm + width_mm && at.y_mm >= y_mm && at.y_mm <= y_mm + height_mm;
}

export function boundsOf(road: Road): Box {
  const xs = road.points.map(([x]) => x);
  const ys = road.points.map(([, y]) => y);
  return { left: Math.min(...xs), right: Math.max(...xs), bottom: Math.min(...ys), top: Math.max(...ys) };
}
