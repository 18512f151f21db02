/** Where a thing of a world is, and the world with it somewhere else. */
import type { OwnWorld } from "../types";
import { dockPlace, roadLine, startPlace } from "./drawing";
import { nearestOn } from "./line";
import { nearestRoad } from "./roads";
import { partsOfKind, type PartReference, tidy } from "./part-reference";
import { withPart } from "./part-edits";

/** How far beyond the edge of a road a dropped start still snaps to it. */
const ROAD_REACH_MM = 60;

/** The start of that number somewhere else: on a road it stays on a road while it is dropped near one, at docks at a dock. */
export function startMoved(world: OwnWorld, at: number, x: number, y: number): OwnWorld {
  const start = world.starts[at];
  if (start === undefined) return world;
  const thing: PartReference = { kind: "start", at };
  if (start.at === "pose") return withPart(world, thing, { ...start, x_mm: tidy(x), y_mm: tidy(y) });
  if (start.at === "dock") {
    const [near] = world.docks
      .map((dock) => ({ dock, place: startPlace(world, { ...start, dock: dock.name }) }))
      .flatMap(({ dock, place }) => (place === null ? [] : [{ dock, off: Math.hypot(place.x - x, place.y - y) }]))
      .sort((a, b) => a.off - b.off);
    return near === undefined ? world : withPart(world, thing, { ...start, dock: near.dock.name });
  }
  if (start.at === "storehouse") {
    const house = world.storehouses.find(
      (one) => x >= one.x_mm && x <= one.x_mm + one.width_mm && y >= one.y_mm && y <= one.y_mm + one.height_mm,
    );
    return house === undefined ? world : withPart(world, thing, { ...start, storehouse: house.name });
  }
  const near = nearestRoad(world, x, y);
  if (near !== null && near.off <= near.road.width_mm / 2 + ROAD_REACH_MM) {
    return withPart(world, thing, { ...start, road: near.road.name, at_mm: Math.round(near.at) });
  }
  const heading = startPlace(world, start)?.heading ?? 0;
  const heading_deg = Math.round((heading * 180) / Math.PI);
  return withPart(world, thing, {
    ...start,
    at: "pose",
    road: "",
    at_mm: 0,
    x_mm: tidy(x),
    y_mm: tidy(y),
    heading_deg,
  });
}

/** Where a thing is: what grids and numbers go by. */
export function anchorOf(world: OwnWorld, { kind, at }: PartReference): { x: number; y: number } | null {
  switch (kind) {
    case "wall": {
      const wall = world.walls[at];
      return wall === undefined ? null : { x: wall.x1, y: wall.y1 };
    }
    case "floor":
    case "line":
    case "road":
      return partsOfKind(world, kind)[at]?.points[0] ?? null;
    case "storehouse": {
      const house = world.storehouses[at];
      return house === undefined ? null : { x: house.x_mm, y: house.y_mm };
    }
    case "dock": {
      const dock = world.docks[at];
      return dock === undefined ? null : dockPlace(world, dock);
    }
    case "start": {
      const start = world.starts[at];
      return start === undefined ? null : startPlace(world, start);
    }
    case "box":
    case "ball":
    case "zone": {
      const part = partsOfKind(world, kind)[at];
      return part === undefined ? null : { x: part.x_mm, y: part.y_mm };
    }
  }
}

/** The world with a thing so many mm further; docks, and starts on a road, move along it. */
export function moved(world: OwnWorld, thing: PartReference, dx: number, dy: number): OwnWorld {
  const { kind, at } = thing;
  switch (kind) {
    case "wall": {
      const wall = world.walls[at];
      if (wall === undefined) return world;
      const { x1, y1, x2, y2 } = wall;
      const after = { x1: tidy(x1 + dx), y1: tidy(y1 + dy), x2: tidy(x2 + dx), y2: tidy(y2 + dy) };
      return withPart(world, thing, after);
    }
    case "floor":
    case "line":
    case "road": {
      const part = partsOfKind(world, kind)[at];
      if (part === undefined) return world;
      const points = part.points.map((point) => ({ ...point, x: tidy(point.x + dx), y: tidy(point.y + dy) }));
      return withPart(world, thing, { ...part, points });
    }
    case "storehouse": {
      const house = world.storehouses[at];
      if (house === undefined) return world;
      return withPart(world, thing, { ...house, x_mm: tidy(house.x_mm + dx), y_mm: tidy(house.y_mm + dy) });
    }
    case "dock": {
      const dock = world.docks[at];
      const place = anchorOf(world, thing);
      const line = dock === undefined ? null : roadLine(world, dock.road);
      if (dock === undefined || place === null || line === null) return world;
      return withPart(world, thing, { ...dock, at_mm: Math.round(nearestOn(line, place.x + dx, place.y + dy).at) });
    }
    case "start": {
      const place = anchorOf(world, thing);
      return place === null ? world : startMoved(world, at, place.x + dx, place.y + dy);
    }
    case "box":
    case "ball":
    case "zone": {
      const part = partsOfKind(world, kind)[at];
      if (part === undefined) return world;
      return withPart(world, thing, { ...part, x_mm: tidy(part.x_mm + dx), y_mm: tidy(part.y_mm + dy) });
    }
  }
}
