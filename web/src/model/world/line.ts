/**
 * Where things are along a line: corners rounded into arcs, sampled as the server samples them (kitrobot.world.geometry).
 *
 * Lengths in mm, angles in radians, y up. A line that cannot be drawn (a radius without room) is null; the server says why.
 */
import type { Corner } from "../types";

const SAGITTA_MM = 0.05;
const MAX_ARC_POINTS = 256;

export interface Line {
  points: [number, number][];
  /** Mm from the first point, on the true arcs, for each point. */
  along: number[];
  headingFrom: number[];
  headingTo: number[];
  closed: boolean;
  length: number;
}

export interface Place {
  x: number;
  y: number;
  heading: number;
}

/** The same direction in (-π, π]. */
export function normalised(angle: number): number {
  const wrapped = angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
  return wrapped <= -Math.PI ? Math.PI : wrapped;
}

function turnAt(before: Corner, corner: Corner, after: Corner): number {
  const arriving = Math.atan2(corner.y - before.y, corner.x - before.x);
  return normalised(Math.atan2(after.y - corner.y, after.x - corner.x) - arriving);
}

function cut(before: Corner, corner: Corner, after: Corner): number {
  if (corner.radius <= 0) return 0;
  const turn = Math.abs(turnAt(before, corner, after));
  if (turn < 1e-9) return 0;
  return turn > Math.PI - 1e-6 ? Infinity : corner.radius * Math.tan(turn / 2);
}

class Path {
  readonly line: Line;

  constructor(closed: boolean) {
    this.line = { points: [], along: [], headingFrom: [], headingTo: [], closed, length: 0 };
  }

  start(x: number, y: number): void {
    this.line.points.push([x, y]);
    this.line.along.push(0);
  }

  private go(x: number, y: number, length: number, from: number, to: number): void {
    const { points, along, headingFrom, headingTo } = this.line;
    points.push([x, y]);
    this.line.length += length;
    along.push(this.line.length);
    headingFrom.push(from);
    headingTo.push(to);
  }

  private get last(): [number, number] {
    return this.line.points.at(-1) ?? [0, 0];
  }

  straight(x: number, y: number, heading: number): void {
    const [fromX, fromY] = this.last;
    const length = Math.hypot(x - fromX, y - fromY);
    if (length > 1e-6) this.go(x, y, length, heading, heading);
  }

  arc(heading: number, turn: number, radius: number): void {
    const step = 2 * Math.acos(Math.max(0, 1 - SAGITTA_MM / radius));
    const count = Math.max(2, Math.min(MAX_ARC_POINTS, Math.ceil(Math.abs(turn) / step)));
    const side = Math.sign(turn) * radius;
    const [x, y] = this.last;
    const [cx, cy] = [x - side * Math.sin(heading), y + side * Math.cos(heading)];
    for (let number = 1; number <= count; number++) {
      const [from, to] = [heading + (turn * (number - 1)) / count, heading + (turn * number) / count];
      this.go(cx + side * Math.sin(to), cy - side * Math.cos(to), (radius * Math.abs(turn)) / count, from, to);
    }
  }
}

/** The sampled line, or null where it cannot be drawn. */
export function lineThrough(corners: readonly Corner[], closed: boolean): Line | null {
  const count = corners.length;
  if (count < (closed ? 3 : 2)) return null;
  const at = (index: number): Corner => corners[(index + count) % count] ?? { x: 0, y: 0, radius: 0 };
  const cuts = corners.map((corner, index) =>
    closed || (index > 0 && index < count - 1) ? cut(at(index - 1), corner, at(index + 1)) : 0,
  );
  const path = new Path(closed);
  for (let index = 0; index < (closed ? count : count - 1); index++) {
    const [here, there] = [at(index), at(index + 1)];
    const length = Math.hypot(there.x - here.x, there.y - here.y);
    if (length < 1e-6) return null;
    const [first, last] = [cuts[index] ?? 0, length - (cuts[(index + 1) % count] ?? 0)];
    if (last - first < -1e-6) return null;
    const [ux, uy] = [(there.x - here.x) / length, (there.y - here.y) / length];
    const heading = Math.atan2(uy, ux);
    if (path.line.points.length === 0) path.start(here.x + first * ux, here.y + first * uy);
    path.straight(here.x + last * ux, here.y + last * uy, heading);
    if ((cuts[(index + 1) % count] ?? 0) > 0) path.arc(heading, turnAt(here, there, at(index + 2)), there.radius);
  }
  return path.line;
}

/** Point and heading so many mm along; round and round on a closed line, held at the ends of an open one. */
export function placeAt(line: Line, at_mm: number): Place {
  const { points, along, headingFrom, headingTo, length, closed } = line;
  const at = closed ? ((at_mm % length) + length) % length : Math.min(Math.max(at_mm, 0), length);
  let stretch = 0;
  while (stretch < along.length - 2 && (along[stretch + 1] ?? 0) <= at) stretch++;
  const [start, end] = [along[stretch] ?? 0, along[stretch + 1] ?? 0];
  const part = end === start ? 0 : (at - start) / (end - start);
  const a = points[stretch] ?? [0, 0];
  const b = points[stretch + 1] ?? a;
  const [from, to] = [headingFrom[stretch] ?? 0, headingTo[stretch] ?? 0];
  return {
    x: a[0] + part * (b[0] - a[0]),
    y: a[1] + part * (b[1] - a[1]),
    heading: normalised(from + part * (to - from)),
  };
}

/** From a point to the stretch between two others: how far off, and the nearest part of the stretch, 0…1. */
export function offStretch(
  x: number,
  y: number,
  a: readonly [number, number],
  b: readonly [number, number],
): { off: number; part: number } {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const squared = dx * dx + dy * dy;
  const part = squared === 0 ? 0 : Math.min(1, Math.max(0, ((x - a[0]) * dx + (y - a[1]) * dy) / squared));
  return { off: Math.hypot(x - a[0] - part * dx, y - a[1] - part * dy), part };
}

/** How far along the nearest point of the line lies, and how far off that is. */
export function nearestOn(line: Line, x: number, y: number): { at: number; off: number } {
  const best = { at: 0, off: Infinity };
  for (let stretch = 0; stretch < line.points.length - 1; stretch++) {
    const [a, b] = [line.points[stretch], line.points[stretch + 1]];
    if (a === undefined || b === undefined) continue;
    const { off, part } = offStretch(x, y, a, b);
    if (off >= best.off) continue;
    const [from, to] = [line.along[stretch] ?? 0, line.along[stretch + 1] ?? 0];
    Object.assign(best, { off, at: from + part * (to - from) });
  }
  return best;
}
