/** Grips: the places by which a thing of a world is changed, and the world with one of them dragged. */
import type { OwnWorld } from "../types";
import { dockPlace, lineOf } from "./drawing";
import { nearestOn } from "./line";
import { withCut, withPoints } from "./roads";
import { type Part, partOf, partsOfKind, type PartReference, tidy } from "./part-reference";
import { shapeOf } from "./shape";
import { withPart } from "./part-edits";

export interface Grip {
  /** "end:0", "corner:2", "cut:1", "size", "heading", "radius", "corner-of", "falloff". */
  id: string;
  x: number;
  y: number;
}

/** How far before a robot its heading is taken hold of. */
export const HEADING_MM = 110;

/** The places by which a thing is changed. */
export function gripsOf(world: OwnWorld, thing: PartReference): Grip[] {
  switch (thing.kind) {
    case "wall": {
      const wall = world.walls[thing.at];
      if (wall === undefined) return [];
      return [
        { id: "end:0", x: wall.x1, y: wall.y1 },
        { id: "end:1", x: wall.x2, y: wall.y2 },
      ];
    }
    case "floor":
    case "line":
    case "road": {
      const part = partsOfKind(world, thing.kind)[thing.at];
      const grips = part?.points.map(({ x, y }, index) => ({ id: `corner:${String(index)}`, x, y })) ?? [];
      return thing.kind === "road" ? [...grips, ...cutsOf(world, thing.at)] : grips;
    }
    case "storehouse": {
      const house = world.storehouses[thing.at];
      if (house === undefined) return [];
      return [{ id: "size", x: house.x_mm + house.width_mm, y: house.y_mm + house.height_mm }];
    }
    case "dock":
      return [];
    case "start": {
      const start = world.starts[thing.at];
      if (start?.at !== "pose") return [];
      const heading = (start.heading_deg * Math.PI) / 180;
      const [x, y] = [start.x_mm + HEADING_MM * Math.cos(heading), start.y_mm + HEADING_MM * Math.sin(heading)];
      return [{ id: "heading", x, y }];
    }
    case "box":
    case "ball":
    case "zone": {
      const shape = shapeOf(world, { kind: thing.kind, at: thing.at });
      if (shape === null) return [];
      const { x, y, radius, width, height } = shape;
      const size =
        radius > 0 ? { id: "radius", x: x + radius, y } : { id: "corner-of", x: x + width / 2, y: y + height / 2 };
      const zone = thing.kind === "zone" ? world.zones?.[thing.at] : undefined;
      if (zone === undefined) return [size];
      return [size, { id: "falloff", x, y: y + (radius || height / 2) + zone.falloff_mm }];
    }
  }
}

function cutsOf(world: OwnWorld, at: number): Grip[] {
  const road = world.roads[at];
  const places = road === undefined ? [] : road.sections.slice(1);
  const line = road === undefined ? null : lineOf(road.points, road.closed);
  if (line === null) return [];
  return places.map(({ from_mm }, index) => {
    const dock = { road: road?.name ?? "", at_mm: from_mm };
    const place = dockPlace(world, dock as Part<"dock">);
    return { id: `cut:${String(index + 1)}`, x: place?.x ?? 0, y: place?.y ?? 0 };
  });
}

const LEAST_MM = 5;

/** What lies around its middle, with its edge dragged to a place; the lower left corner of a rectangle stays. */
function resized(world: OwnWorld, thing: PartReference, what: string, x: number, y: number): OwnWorld {
  const { kind, at } = thing;
  if (kind !== "box" && kind !== "ball" && kind !== "zone") return world;
  const part = partOf(world, { kind, at });
  const shape = shapeOf(world, { kind, at });
  if (part === undefined || shape === null) return world;
  if (what === "radius") {
    const radius_mm = Math.max(LEAST_MM, Math.round(Math.hypot(x - shape.x, y - shape.y)));
    return withPart(world, thing, { ...part, radius_mm });
  }
  if (what === "falloff") {
    const falloff_mm = Math.max(0, tidy(y - shape.y - (shape.radius || shape.height / 2)));
    return withPart(world, thing, { ...part, falloff_mm });
  }
  const [left, bottom] = [shape.x - shape.width / 2, shape.y - shape.height / 2];
  const [width_mm, height_mm] = [Math.max(LEAST_MM, tidy(x - left)), Math.max(LEAST_MM, tidy(y - bottom))];
  const middle = { x_mm: tidy(left + width_mm / 2), y_mm: tidy(bottom + height_mm / 2) };
  return withPart(world, thing, { ...part, ...middle, width_mm, height_mm });
}

/** The world with a grip of a thing brought to a place. */
export function dragged(world: OwnWorld, thing: PartReference, grip: string, x: number, y: number): OwnWorld {
  const [what = "", number = "0"] = grip.split(":");
  const index = Number(number);
  const [tx, ty] = [tidy(x), tidy(y)];
  switch (what) {
    case "end": {
      const wall = world.walls[thing.at];
      if (wall === undefined) return world;
      return withPart(world, thing, index === 0 ? { ...wall, x1: tx, y1: ty } : { ...wall, x2: tx, y2: ty });
    }
    case "corner": {
      const part = partOf(world, thing);
      if (part === undefined || !("points" in part)) return world;
      const points = part.points.map((point, at) => (at === index ? { ...point, x: tx, y: ty } : point));
      return withPoints(world, thing, points);
    }
    case "cut": {
      const road = world.roads[thing.at];
      const line = road === undefined ? null : lineOf(road.points, road.closed);
      return line === null ? world : withCut(world, thing.at, index, Math.round(nearestOn(line, x, y).at));
    }
    case "size": {
      const house = world.storehouses[thing.at];
      if (house === undefined) return world;
      const [width_mm, height_mm] = [Math.max(10, tidy(tx - house.x_mm)), Math.max(10, tidy(ty - house.y_mm))];
      return withPart(world, thing, { ...house, width_mm, height_mm });
    }
    case "heading": {
      const start = world.starts[thing.at];
      if (start === undefined) return world;
      const heading_deg = Math.round((Math.atan2(y - start.y_mm, x - start.x_mm) * 180) / Math.PI);
      return withPart(world, thing, { ...start, heading_deg });
    }
    case "radius":
    case "corner-of":
    case "falloff":
      return resized(world, thing, what, tx, ty);
    default:
      return world;
  }
}
