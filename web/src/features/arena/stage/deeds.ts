/**
 * What robots did in a run, read from the ways that they went and from what they showed: lines that they followed, colours that
 * they found or left, places that they came back to, walls that they stopped before, boxes, lamps, parts and numbers.
 *
 * Each kind of deed is found in every run alike: nothing here knows a mission. Lengths in mm, times in ticks.
 */
import type { World } from "../../../model/types";
import type { Pose } from "../../../api/wire";
import { nearestOn } from "../../../components/scene/geometry";

export type Colour = World["floors"][number]["colour"];

export type Deed =
  | { kind: "delivered"; done: number; total: number }
  | { kind: "pushed"; count: number; mm: number }
  | { kind: "found" | "left"; name: string; colour: Colour; tick: number }
  | { kind: "followed"; name: string; mm: number }
  | { kind: "returned"; name: string; count: number }
  | { kind: "before-wall"; name: string; mm: number }
  | { kind: "apart"; count: number; least: number; most: number }
  | { kind: "changed"; name: string; text: string }
  | { kind: "touched"; count: number }
  | { kind: "untouched" }
  | { kind: "lit"; name: string; robots: number; count: number }
  | { kind: "turned"; name: string; angle: number }
  | { kind: "used"; name: string; parts: readonly string[] }
  | { kind: "counted"; name: string; value: number };

/** Where one robot was, with the ticks; places are at least 10 mm apart. */
export interface RobotPath {
  name: string;
  /** Of its body, in mm. */
  length_mm: number;
  xs: readonly number[];
  ys: readonly number[];
  ticks: readonly number[];
  /** How far it drove, also where its places are not kept any more. */
  mm: number;
}

/** Who drove less than this went nowhere in particular. */
const LEAST_MM = 500;
/** Nearer than this to its beginning it is back. */
const BACK_MM = 60;
/** So far from its beginning it has been at least, who comes back. */
const AWAY_MM = 150;
/** This share of the places of a way is on a line that is followed, which may be beside by so much. */
const [ON_LINE, BESIDE_MM] = [0.9, 35];
/** A wall that is further away is not what somebody stopped before. */
const WALL_MM = 300;

function isInside(points: readonly (readonly [number, number])[], x: number, y: number): boolean {
  let inside = false;
  points.forEach(([bx, by], at) => {
    const [ax, ay] = points.at(at - 1) ?? [bx, by];
    if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) inside = !inside;
  });
  return inside;
}

/** The colour of the floor there, as it is drawn: lines lie over floors, and the last of each is on top. */
export function colourAt({ floors, lines }: Pick<World, "floors" | "lines">, x: number, y: number): Colour | null {
  const line = lines.findLast((one) => nearestOn(one, x, y).off <= one.width_mm / 2);
  return line?.colour ?? floors.findLast(({ points }) => isInside(points, x, y))?.colour ?? null;
}

/** The colours under the middle of a robot at a place of its way, and under its front. */
function coloursAt(world: World, { xs, ys, length_mm }: RobotPath, at: number): readonly (Colour | null)[] {
  const [x, y] = [xs[at] ?? 0, ys[at] ?? 0];
  const before = Math.max(at - 1, 0);
  const [dx, dy] = [x - (xs[before] ?? x), y - (ys[before] ?? y)];
  const long = Math.hypot(dx, dy);
  const front = long === 0 ? 0 : length_mm / 2 / long;
  return [colourAt(world, x, y), colourAt(world, x + dx * front, y + dy * front)];
}

/** The colour that a robot came to and stayed on, or the one that it began on and left. */
export function colourDeeds(world: World, way: RobotPath): Deed[] {
  const { name, xs, ticks } = way;
  if (world.floors.length + world.lines.length === 0 || xs.length < 2) return [];
  const [start] = coloursAt(world, way, 0);
  const ends = coloursAt(world, way, xs.length - 1).filter((one) => one !== null);
  const colour = ends.find((one) => one !== start);
  if (colour !== undefined) {
    const at = xs.findIndex((_, index) => index > 0 && coloursAt(world, way, index).includes(colour));
    return [{ kind: "found", name, colour, tick: ticks[at] ?? 0 }];
  }
  if (start == null || ends.length > 0) return [];
  const last = xs.findLastIndex((_, index) => coloursAt(world, way, index).includes(start));
  return [{ kind: "left", name, colour: start, tick: ticks[last] ?? 0 }];
}

/** The line that a robot kept to. */
export function lineDeeds(world: World, { name, xs, ys, mm }: RobotPath): Deed[] {
  if (mm < LEAST_MM) return [];
  const followed = world.lines.some((line) => {
    const on = xs.filter((x, at) => nearestOn(line, x, ys[at] ?? 0).off <= line.width_mm / 2 + BESIDE_MM);
    if (on.length < ON_LINE * xs.length) return false;
    const along = xs.map((x, at) => nearestOn(line, x, ys[at] ?? 0).along);
    // Who drives across a line and back is on it, too, but goes nowhere along it.
    return Math.max(...along) - Math.min(...along) >= LEAST_MM;
  });
  return followed ? [{ kind: "followed", name, mm }] : [];
}

/** Who is back where it began, after it has been away. */
export function returnDeeds(ways: readonly RobotPath[]): Deed[] {
  const back = ways.filter(({ xs, ys, mm }) => {
    const from = (at: number) => Math.hypot((xs[at] ?? 0) - (xs[0] ?? 0), (ys[at] ?? 0) - (ys[0] ?? 0));
    return mm >= LEAST_MM && from(xs.length - 1) <= BACK_MM && xs.some((_, at) => from(at) >= AWAY_MM);
  });
  const [first] = back;
  return first === undefined ? [] : [{ kind: "returned", name: first.name, count: back.length }];
}

/** Further than this from each other robots are no train, in mm. */
const TRAIN_MM = 800;

/** Where a robot was at a tick. */
function placeAt({ xs, ys, ticks }: RobotPath, tick: number): [number, number] {
  const at = Math.max(
    ticks.findLastIndex((one) => one <= tick),
    0,
  );
  return [xs[at] ?? 0, ys[at] ?? 0];
}

/** Robots that drove far, each keeping near to the one before it. */
export function trainDeeds(ways: readonly RobotPath[]): Deed[] {
  if (ways.length < 2 || ways.some(({ mm }) => mm < 2 * LEAST_MM)) return [];
  let [least, most] = [Infinity, 0];
  ways.slice(1).forEach((way, index) => {
    const ahead = ways[index];
    if (ahead === undefined) return;
    for (const tick of way.ticks) {
      const [[ax, ay], [bx, by]] = [placeAt(ahead, tick), placeAt(way, tick)];
      const apart = Math.hypot(bx - ax, by - ay);
      [least, most] = [Math.min(least, apart), Math.max(most, apart)];
    }
  });
  return most <= TRAIN_MM ? [{ kind: "apart", count: ways.length, least, most }] : [];
}

/** How far before the front of a robot the next wall is; infinite where there is none. */
export function wallAhead({ walls }: Pick<World, "walls">, pose: Pose, length_mm: number): number {
  const [dx, dy] = [Math.cos(pose.heading_rad), Math.sin(pose.heading_rad)];
  const found = walls.map(({ x1, y1, x2, y2 }) => {
    const [wx, wy] = [x2 - x1, y2 - y1];
    const cross = dx * wy - dy * wx;
    if (Math.abs(cross) < 1e-9) return Infinity;
    const [px, py] = [x1 - pose.x_mm, y1 - pose.y_mm];
    const away = (px * wy - py * wx) / cross;
    const along = (px * dy - py * dx) / cross;
    return away > 0 && along >= 0 && along <= 1 ? away : Infinity;
  });
  return Math.max(Math.min(...found, Infinity) - length_mm / 2, 0);
}

/** Who stands before a wall in the end. */
export function wallDeeds(world: World, way: RobotPath, pose: Pose): Deed[] {
  const mm = wallAhead(world, pose, way.length_mm);
  return way.mm >= AWAY_MM && mm <= WALL_MM ? [{ kind: "before-wall", name: way.name, mm }] : [];
}
