/**
 * What a line of a pen looks like: its sides and corners, and whether it is closed. Lengths in mm, angles in degrees.
 *
 * A pen leaves a point at each step of the simulation, so corners are a little round and ends do not meet to the mm. A
 * shape that is drawn over and over is that shape once. A curve has no sides.
 */

export type Line = readonly (readonly [x: number, y: number])[];

export interface Shape {
  closed: boolean;
  sides: readonly number[];
  /** The angles between sides, on the inner side of each corner. */
  corners: readonly number[];
}

type Point = Line[number];

/** How far a point may be off, as a share of the size of the line, and in mm at least. */
const [OFF, OFF_MM] = [0.02, 4];
/** How far ends may be apart that meet, as a share of the mean side, and in mm at least. */
const [APART, APART_MM] = [0.12, 12];
/** A smaller turn is no corner, in degrees. */
const TURN = 18;
const MOST_SIDES = 24;
/** So many sides and more with no turn larger than this are a curve. */
const [ROUND_SIDES, ROUND_TURN] = [7, 40];

function distance([ax, ay]: Point, [bx, by]: Point): number {
  return Math.hypot(bx - ax, by - ay);
}

export function lengthOf(line: Line): number {
  return line.reduce((sum, point, at) => sum + distance(line[at - 1] ?? point, point), 0);
}

function offLine([x, y]: Point, from: Point, to: Point): number {
  const long = distance(from, to);
  if (long < 1e-6) return distance([x, y], from);
  return Math.abs((to[0] - from[0]) * (y - from[1]) - (to[1] - from[1]) * (x - from[0])) / long;
}

/** The corners of a line, its ends among them: points are left out that are nearly on the way between others. */
function simplify(line: Line, off: number): Point[] {
  const first = line[0];
  const last = line.at(-1);
  if (first === undefined || last === undefined) return [];
  const kept = new Set([0, line.length - 1]);
  const todo: [number, number][] = [[0, line.length - 1]];
  for (let next = todo.pop(); next !== undefined; next = todo.pop()) {
    const [from, to] = next;
    let [most, at] = [off, -1];
    for (let index = from + 1; index < to; index++) {
      const far = offLine(line[index] ?? first, line[from] ?? first, line[to] ?? last);
      if (far > most) [most, at] = [far, index];
    }
    if (at < 0) continue;
    kept.add(at);
    todo.push([from, at], [at, to]);
  }
  return line.filter((_, at) => kept.has(at));
}

/** By how much the way turns at `at`, in degrees, from 0 to 180. */
function turnAt(before: Point, at: Point, after: Point): number {
  const turn = Math.atan2(after[1] - at[1], after[0] - at[0]) - Math.atan2(at[1] - before[1], at[0] - before[0]);
  return (Math.abs(Math.atan2(Math.sin(turn), Math.cos(turn))) * 180) / Math.PI;
}

/** Without points at which the way hardly turns, and without pieces that are only the round of a corner. */
function withoutBends(points: Point[], short: number): Point[] {
  const joined = points.filter((point, at) => at === 0 || distance(point, points[at - 1] ?? point) > short);
  const end = points.at(-1);
  if (end !== undefined && joined.length > 1 && joined.at(-1) !== end) joined.splice(-1, 1, end);
  return joined.filter((point, at) => {
    const [before, after] = [joined[at - 1], joined[at + 1]];
    return before === undefined || after === undefined || turnAt(before, point, after) >= TURN;
  });
}

/** Each corner where the way between its neighbours bends most: between two far points the first guess may be beside it. */
function atBends(line: Line, points: Point[]): Point[] {
  const found = points.map((point) => line.indexOf(point));
  for (let at = 1; at < found.length - 1; at++) {
    const [from, to] = [line[found[at - 1] ?? 0], line[found[at + 1] ?? 0]];
    if (from === undefined || to === undefined) continue;
    let most = -1;
    for (let index = (found[at - 1] ?? 0) + 1; index < (found[at + 1] ?? 0); index++) {
      const far = offLine(line[index] ?? from, from, to);
      if (far > most) [most, found[at]] = [far, index];
    }
  }
  return found.map((index, at) => line[index] ?? points[at] ?? [0, 0]);
}

/** After how many sides the line is back where it began and goes the same way again; 0 where it never is. */
function period(points: Point[], near: number): number {
  const meets = (one: number, other: number) => {
    const [a, b] = [points[one], points[other]];
    return a !== undefined && b !== undefined && distance(a, b) <= near;
  };
  for (let sides = 2; sides < points.length; sides++) {
    if (!meets(0, sides)) continue;
    // The last round may end on its way.
    const again = points.slice(sides, -1).every((_, at) => meets(at + sides, at % sides));
    if (again) return sides;
  }
  return 0;
}

/** Null for a curve, and for a line too short to speak of. */
export function shapeOf(line: Line): Shape | null {
  const [xs, ys] = [line.map(([x]) => x), line.map(([, y]) => y)];
  const size = Math.hypot(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys));
  const off = Math.max(size * OFF, OFF_MM);
  if (line.length < 2 || size < 2 * OFF_MM) return null;
  let points = withoutBends(simplify(line, off), off);
  for (let round = 0; round < 2; round++) points = atBends(line, points);
  if (points.length > 12 * MOST_SIDES) return null;
  const mean = lengthOf(points) / Math.max(points.length - 1, 1);
  const sides = period(points, Math.max(mean * APART, APART_MM));
  // Two sides that meet are a way there and back.
  const closed = sides > 2;
  if (closed) points = points.slice(0, sides);
  const [start, next, last] = [points[0], points[1], points.at(-1)];
  // It may have begun in the middle of a side.
  if (closed && start !== undefined && next !== undefined && last !== undefined && turnAt(last, start, next) < TURN) {
    points.shift();
  }
  if (points.length - (closed ? 0 : 1) > MOST_SIDES) return null;
  const at = (index: number): Point => points[(index + points.length) % points.length] ?? [0, 0];
  const count = closed ? points.length : points.length - 1;
  const lengths = Array.from({ length: count }, (_, index) => distance(at(index), at(index + 1)));
  const turns = points
    .map((point, index) => turnAt(at(index - 1), point, at(index + 1)))
    .slice(closed ? 0 : 1, closed ? undefined : -1);
  if (turns.length >= ROUND_SIDES && turns.every((turn) => turn <= ROUND_TURN)) return null;
  return { closed, sides: lengths, corners: turns.map((turn) => 180 - turn) };
}

/** Lines that go on where another one ends are one line. */
export function joinLines(lines: readonly Line[]): Line[] {
  const joined: Point[][] = [];
  for (const line of lines) {
    const [first, before] = [line[0], joined.at(-1)?.at(-1)];
    if (first === undefined) continue;
    if (before !== undefined && distance(before, first) < OFF_MM) joined.at(-1)?.push(...line.slice(1));
    else joined.push([...line]);
  }
  return joined;
}

/** The one value of numbers that are nearly the same; null for others. */
export function commonOf(numbers: readonly number[], share: number, least: number): number | null {
  const mean = numbers.reduce((sum, one) => sum + one, 0) / numbers.length;
  return numbers.every((one) => Math.abs(one - mean) <= Math.max(mean * share, least)) ? mean : null;
}
