/** What lies at a place of a world, and where something that is dragged comes to lie: on the grid or on an end nearby. */
import type { OwnWorld } from "../types";
import { lineOf } from "./drawing";
import { gripsOf } from "./grips";
import { nearestOn, offStretch } from "./line";
import { anchorOf } from "./part-movement";
import { offShape, shapeOf } from "./shape";
import { GRID_MM, type Kind, partsOfKind, isSamePart, type PartReference } from "./part-reference";

const DOCK_MM = 70;
const ROBOT_MM = 55;

function distanceToPart(world: OwnWorld, thing: PartReference, x: number, y: number): number {
  switch (thing.kind) {
    case "wall": {
      const wall = world.walls[thing.at];
      return wall === undefined ? Infinity : offStretch(x, y, [wall.x1, wall.y1], [wall.x2, wall.y2]).off;
    }
    case "line":
    case "road": {
      const part = partsOfKind(world, thing.kind)[thing.at];
      const line = part === undefined ? null : lineOf(part.points, part.closed);
      return line === null || part === undefined ? Infinity : nearestOn(line, x, y).off - part.width_mm / 2;
    }
    case "floor": {
      const border = lineOf(world.floors[thing.at]?.points ?? [], true)?.points ?? [];
      let inside = false;
      border.forEach(([bx, by], index) => {
        const [ax, ay] = border[(index + border.length - 1) % border.length] ?? [bx, by];
        if (by > y !== ay > y && x < ((ax - bx) * (y - by)) / (ay - by) + bx) inside = !inside;
      });
      return inside ? 0 : Infinity;
    }
    case "storehouse": {
      const house = world.storehouses[thing.at];
      if (house === undefined) return Infinity;
      const [px, py] = [x - house.x_mm, y - house.y_mm];
      return px >= 0 && px <= house.width_mm && py >= 0 && py <= house.height_mm ? 0 : Infinity;
    }
    case "dock":
    case "start": {
      const place = anchorOf(world, thing);
      const reach = thing.kind === "dock" ? DOCK_MM : ROBOT_MM;
      return place === null ? Infinity : Math.hypot(place.x - x, place.y - y) - reach;
    }
    case "box":
    case "ball":
    case "zone": {
      const shape = shapeOf(world, { kind: thing.kind, at: thing.at });
      return shape === null ? Infinity : offShape(shape, x, y);
    }
  }
}

const ON_TOP: readonly Kind[] = ["start", "ball", "box", "wall", "dock", "storehouse", "line", "road", "zone", "floor"];
/** What has to be pressed itself: it may cover most of a world. */
const LARGE: readonly Kind[] = ["floor", "zone"];

/** What lies at a place, at most `reach` mm off: of these kinds, the first one first; without, what is drawn on top. */
export function thingAt(
  world: OwnWorld,
  x: number,
  y: number,
  reach: number,
  kinds: readonly Kind[] = ON_TOP,
): PartReference | null {
  for (const kind of kinds) {
    const near = partsOfKind(world, kind)
      .map((_, at) => ({ at, off: distanceToPart(world, { kind, at }, x, y) }))
      .filter(({ off }) => off <= (LARGE.includes(kind) ? 0 : reach))
      .sort((a, b) => a.off - b.off || b.at - a.at)[0];
    if (near !== undefined) return { kind, at: near.at };
  }
  return null;
}

/** The ends of walls and lines that something dragged may take hold of. */
export function endsOf(world: OwnWorld, but: readonly PartReference[]): { x: number; y: number }[] {
  const kinds: Kind[] = ["wall", "floor", "line", "road"];
  return kinds.flatMap((kind) =>
    partsOfKind(world, kind).flatMap((_, at) =>
      but.some((one) => isSamePart(one, { kind, at }))
        ? []
        : gripsOf(world, { kind, at }).filter((grip) => !grip.id.startsWith("cut")),
    ),
  );
}

/** A place on the grid, or on an end within reach. */
export function snapped(
  x: number,
  y: number,
  ends: readonly { x: number; y: number }[],
  reach: number,
): { x: number; y: number; end: boolean } {
  let best: { x: number; y: number; off: number } | null = null;
  for (const end of ends) {
    const off = Math.hypot(end.x - x, end.y - y);
    if (off <= reach && (best === null || off < best.off)) best = { x: end.x, y: end.y, off };
  }
  if (best !== null) return { x: best.x, y: best.y, end: true };
  return { x: Math.round(x / GRID_MM) * GRID_MM + 0, y: Math.round(y / GRID_MM) * GRID_MM + 0, end: false };
}
