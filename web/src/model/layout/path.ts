/** Lines as SVG: polylines with rounded corners, arrowheads. */
import type { Box, LayoutNode, Point } from "./types";

const RADIUS = 8;
export const HEAD = { w: 8, h: 9 };

/** The path of a line with right angles; it stops short of its end where a head stands. */
export function roundedPath(points: Point[], head: boolean): string {
  const line = head ? shortened(points) : points;
  const [first, ...rest] = line;
  if (first === undefined) return "";
  let path = `M${at(first)}`;
  rest.forEach((corner, index) => {
    const before = line[index];
    const after = line[index + 2];
    if (before === undefined || after === undefined) {
      path += `L${at(corner)}`;
      return;
    }
    const radius = Math.min(RADIUS, distance(before, corner) / 2, distance(corner, after) / 2);
    path += `L${at(towards(corner, before, radius))}Q${at(corner)} ${at(towards(corner, after, radius))}`;
  });
  return path;
}

/** The arrowhead at the end of a line, as a closed path. */
export function headPath(points: Point[]): string {
  const tip = points.at(-1);
  const before = points.at(-2);
  if (tip === undefined || before === undefined) return "";
  const length = distance(before, tip) || 1;
  const x = (tip.x - before.x) / length;
  const y = (tip.y - before.y) / length;
  const base = { x: tip.x - x * HEAD.h, y: tip.y - y * HEAD.h };
  const left = { x: base.x - (y * HEAD.w) / 2, y: base.y + (x * HEAD.w) / 2 };
  const right = { x: base.x + (y * HEAD.w) / 2, y: base.y - (x * HEAD.w) / 2 };
  return `M${at(tip)}L${at(left)}L${at(right)}Z`;
}

function shortened(points: Point[]): Point[] {
  const tip = points.at(-1);
  const before = points.at(-2);
  if (tip === undefined || before === undefined) return points;
  return [...points.slice(0, -1), towards(tip, before, Math.min(HEAD.h - 2, distance(before, tip)))];
}

function at({ x, y }: Point): string {
  return `${String(round(x))} ${String(round(y))}`;
}

function round(value: number): number {
  return Math.round(value * 10) / 10;
}

const SLOPE = 14;

/** The corners of a hexagon as SVG writes them. */
export function hexagonPoints({ x, y, w, h }: Pick<LayoutNode, "x" | "y" | "w" | "h">): string {
  return [
    { x, y: y + h / 2 },
    { x: x + SLOPE, y },
    { x: x + w - SLOPE, y },
    { x: x + w, y: y + h / 2 },
    { x: x + w - SLOPE, y: y + h },
    { x: x + SLOPE, y: y + h },
  ]
    .map((corner) => `${String(corner.x)},${String(corner.y)}`)
    .join(" ");
}

/** The box around boxes, of which there is one at least. */
export function boundsOf(boxes: readonly Box[]): Box {
  const fold = (pick: (one: number, other: number) => number, of: (box: Box) => number) =>
    boxes.map(of).reduce((one, other) => pick(one, other));
  const x = fold(Math.min, (box) => box.x);
  const y = fold(Math.min, (box) => box.y);
  const right = fold(Math.max, (box) => box.x + box.w);
  const bottom = fold(Math.max, (box) => box.y + box.h);
  return { x, y, w: right - x, h: bottom - y };
}

export function distance(a: Point, b: Point): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

function towards(from: Point, to: Point, by: number): Point {
  const whole = distance(from, to) || 1;
  return { x: from.x + ((to.x - from.x) * by) / whole, y: from.y + ((to.y - from.y) * by) / whole };
}

/** How far a point is from a line. */
export function distanceToLine(points: Point[], point: Point): number {
  let least = Infinity;
  for (let index = 1; index < points.length; index++) {
    const a = points[index - 1];
    const b = points[index];
    if (a === undefined || b === undefined) continue;
    const length = distance(a, b);
    const along =
      length === 0 ? 0 : ((point.x - a.x) * (b.x - a.x) + (point.y - a.y) * (b.y - a.y)) / (length * length);
    const nearest = towards(a, b, Math.min(1, Math.max(0, along)) * length);
    least = Math.min(least, distance(nearest, point));
  }
  return least;
}
