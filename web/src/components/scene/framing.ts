/**
 * What the camera shows by itself: the robots, where they have been and what lies in the world; the whole world only where a
 * robot is still seen well in it. Boxes are in mm. When it looks again is the painter's matter.
 */
import type { World } from "../../model/types";
import type { Box, Camera, Room } from "./camera";
import { ROBOT_MM } from "./geometry";

/** Room around what lies in the world, so that a robot has place beside it; around roads, which robots do not leave. */
const [BESIDE_MM, ROADSIDE_MM] = [150, 50];
/** Around the middle of a robot, in its lengths. */
const BODY = 0.62;
/** A world is small when a usual robot is so long on the screen while all of it is shown, in px. */
const SEEN_WELL_PX = 64;
/** Of a crowd all is shown. */
const CROWD = 24;

export const EMPTY: Box = { left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity };

export function isEmpty({ left, right, bottom, top }: Box): boolean {
  return left > right || bottom > top;
}

export function around(x: number, y: number, half_mm: number, high_mm = half_mm): Box {
  return { left: x - half_mm, right: x + half_mm, bottom: y - high_mm, top: y + high_mm };
}

export function union(one: Box, other: Box): Box {
  return {
    left: Math.min(one.left, other.left),
    right: Math.max(one.right, other.right),
    bottom: Math.min(one.bottom, other.bottom),
    top: Math.max(one.top, other.top),
  };
}

/** At least so wide and high, around the same middle; `factor` times as large where that is more. */
export function atLeast(box: Box, least_mm: number, factor = 1): Box {
  const half = (from: number, to: number) => Math.max(((to - from) * factor) / 2, least_mm / 2);
  return around(
    (box.left + box.right) / 2,
    (box.bottom + box.top) / 2,
    half(box.left, box.right),
    half(box.bottom, box.top),
  );
}

function pointsBox(points: Iterable<readonly [number, number]>, more_mm = 0): Box {
  let box = EMPTY;
  for (const [x, y] of points) box = union(box, around(x, y, more_mm));
  return box;
}

/** Walls that are not an edge of the room: those that somebody set up in it. */
function innerWalls({ walls }: World): [number, number][] {
  const room = pointsBox(
    walls.flatMap(({ x1, y1, x2, y2 }): [number, number][] => [
      [x1, y1],
      [x2, y2],
    ]),
  );
  return walls.flatMap(({ x1, y1, x2, y2 }): [number, number][] => {
    const along = (a: number, b: number, edges: number[]) =>
      Math.abs(a - b) < 1 && edges.some((e) => Math.abs(a - e) < 1);
    const edge = along(x1, x2, [room.left, room.right]) || along(y1, y2, [room.bottom, room.top]);
    return edge
      ? []
      : [
          [x1, y1],
          [x2, y2],
        ];
  });
}

function inside({ width_mm, height_mm }: World, box: Box): Box {
  return {
    left: Math.max(box.left, 0),
    right: Math.min(box.right, width_mm),
    bottom: Math.max(box.bottom, 0),
    top: Math.min(box.top, height_mm),
  };
}

const known = new WeakMap<World, Box>();

/** The box around what there is to see in a world besides robots, with room around it; empty in an empty room. */
export function sightsOf(world: World): Box {
  const before = known.get(world);
  if (before !== undefined) return before;
  let box = pointsBox(innerWalls(world), BESIDE_MM);
  for (const { points, width_mm } of world.roads) box = union(box, pointsBox(points, width_mm / 2 + ROADSIDE_MM));
  for (const { points, width_mm } of world.lines) box = union(box, pointsBox(points, width_mm / 2 + BESIDE_MM));
  for (const { points } of world.floors) box = union(box, pointsBox(points, BESIDE_MM));
  const add = (x: number, y: number, width: number, height: number, beside = BESIDE_MM) => {
    box = union(box, around(x, y, width / 2 + beside, height / 2 + beside));
  };
  for (const { x_mm, y_mm, width_mm, height_mm } of world.storehouses) {
    add(x_mm + width_mm / 2, y_mm + height_mm / 2, width_mm, height_mm, ROADSIDE_MM);
  }
  for (const { x_mm, y_mm, width_mm, height_mm } of world.things ?? []) add(x_mm, y_mm, width_mm, height_mm);
  for (const { x_mm, y_mm, radius_mm, width_mm, height_mm } of world.zones ?? []) {
    add(x_mm, y_mm, Math.max(2 * radius_mm, width_mm), Math.max(2 * radius_mm, height_mm));
  }
  const sights = isEmpty(box) ? box : inside(world, box);
  known.set(world, sights);
  return sights;
}

/** The box around all that a world has, and around robots at these places; the whole world where it has nothing else. */
export function contentOf(world: World, places: readonly { x_mm: number; y_mm: number }[]): Box {
  const ends = world.walls.flatMap(({ x1, y1, x2, y2 }): [number, number][] => [
    [x1, y1],
    [x2, y2],
  ]);
  const content = union(sightsOf(world), pointsBox(ends, BESIDE_MM));
  if (isEmpty(content)) return { left: 0, right: world.width_mm, bottom: 0, top: world.height_mm };
  const robots = [...world.starts, ...places].map(({ x_mm, y_mm }): [number, number] => [x_mm, y_mm]);
  return inside(world, union(content, pointsBox(robots, ROBOT_MM * BODY)));
}

interface RobotBody {
  x_mm: number;
  y_mm: number;
  length_mm: number;
}

/**
 * What is to be seen now; null where that is all there is: a crowd, nobody, a world that is small beside `whole`, the
 * camera that shows all of it in the room, or one that this camera shows from nearer.
 *
 * @param been where robots have been, as far as anybody saw it.
 */
export function subjectOf(
  world: World,
  robots: readonly RobotBody[],
  been: Box,
  whole: Camera,
  room: Room,
): Box | null {
  if (robots.length === 0 || robots.length > CROWD || whole.scale * ROBOT_MM >= SEEN_WELL_PX) return null;
  const actors = robots.reduce(
    (box, { x_mm, y_mm, length_mm }) => union(box, around(x_mm, y_mm, length_mm * BODY)),
    been,
  );
  const subject = union(sightsOf(world), actors);
  const isAsLarge =
    (subject.right - subject.left) * whole.scale >= room.width ||
    (subject.top - subject.bottom) * whole.scale >= room.height;
  return isAsLarge && isOnScreen(actors, whole, room, 0) ? null : subject;
}

/** Whether all of a box is on a screen of that size, `margin` px from its edges at least. */
export function isOnScreen({ left, right, bottom, top }: Box, camera: Camera, room: Room, margin: number): boolean {
  const { scale, x, y } = camera;
  return (
    x + left * scale >= margin &&
    x + right * scale <= room.width - margin &&
    y - top * scale >= margin &&
    y - bottom * scale <= room.height - margin
  );
}

/** On the way from one camera to another, at a share from 0 to 1: slowly at first and at last. */
export function cameraBetween(from: Camera, to: Camera, share: number): Camera {
  if (share >= 1) return to;
  const eased = share * share * (3 - 2 * share);
  const between = (a: number, b: number) => a + (b - a) * eased;
  return { scale: between(from.scale, to.scale), x: between(from.x, to.x), y: between(from.y, to.y) };
}
