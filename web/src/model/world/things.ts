/**
 * The things of a mission's own world: which there are, where they can be taken hold of, and the world with one of them
 * moved, changed, put in or taken out.
 *
 * A thing is a kind and its number from 0, as the server's problems name it. Pure: worlds are never changed in place.
 * Left to others: commands and names that the mission uses (commands/changeOwnWorld), what is allowed (the server).
 */
import type { Corner, OwnWorld } from "../types";
import { dockPlace, lineOf, roadLine, startPlace } from "./drawn";
import { nearestOn, offStretch } from "./line";
import {
  type AnyPart,
  FIELD,
  GRID_MM,
  type Kind,
  KINDS,
  type Part,
  partOf,
  partsOfKind,
  sameThing,
  type Thing,
  tidy,
} from "./thing";

function withParts(world: OwnWorld, kind: Kind, parts: readonly AnyPart[]): OwnWorld {
  return { ...world, [FIELD[kind]]: parts };
}

/** The world with something else in the place of a thing. */
export function withPart(world: OwnWorld, { kind, at }: Thing, part: AnyPart): OwnWorld {
  const parts = partsOfKind(world, kind).map((one, index) => (index === at ? part : one));
  return withParts(world, kind, parts);
}

export function added(world: OwnWorld, kind: Kind, part: AnyPart): { world: OwnWorld; thing: Thing } {
  const parts = partsOfKind(world, kind);
  return { world: withParts(world, kind, [...parts, part]), thing: { kind, at: parts.length } };
}

/** `things`, and what cannot be without them: docks of a road or storehouse, starts on them. */
export function withDependents(world: OwnWorld, things: readonly Thing[]): Thing[] {
  const names = (kind: "road" | "storehouse" | "dock", of: readonly Thing[]) =>
    of.flatMap((thing) => (thing.kind === kind ? [partsOfKind(world, kind)[thing.at]?.name ?? ""] : []));
  const found = [...things];
  const add = (kind: Kind, at: number) => {
    if (!found.some((one) => sameThing(one, { kind, at }))) found.push({ kind, at });
  };
  const [roads, houses] = [names("road", found), names("storehouse", found)];
  world.docks.forEach((dock, at) => {
    if (roads.includes(dock.road) || houses.includes(dock.storehouse)) add("dock", at);
  });
  const docks = names("dock", found);
  world.starts.forEach((start, at) => {
    const on = { road: roads, storehouse: houses, dock: docks, pose: [] }[start.at] as string[];
    if (start.at !== "pose" && on.includes(start[start.at])) add("start", at);
  });
  return found;
}

export function removed(world: OwnWorld, things: readonly Thing[]): OwnWorld {
  return KINDS.reduce((left, kind) => {
    const gone = new Set(things.flatMap((thing) => (thing.kind === kind ? [thing.at] : [])));
    if (gone.size === 0) return left;
    return withParts(
      left,
      kind,
      partsOfKind(left, kind).filter((_, at) => !gone.has(at)),
    );
  }, world);
}

// -- roads that change their shape

/** A road with other corners: its cuts stay where they are, and come closer together when it becomes too short. */
function reshaped(world: OwnWorld, at: number, points: Corner[]): OwnWorld {
  const road = world.roads[at];
  if (road === undefined) return world;
  const length = lineOf(points, road.closed)?.length ?? 0;
  const last = road.sections.at(-1)?.from_mm ?? 0;
  const factor = length > 0 && last >= length ? (length * 0.95) / last : 1;
  const held = (mm: number | null) => (mm === null ? null : tidy(mm * factor));
  const sections = road.sections.map((section, index) => ({
    ...section,
    from_mm: tidy(section.from_mm * factor),
    to_mm: index === road.sections.length - 1 ? null : held(section.to_mm),
  }));
  const on = (mm: number) => (length > 0 ? tidy(Math.min(mm, Math.floor(length))) : mm);
  return {
    ...withPart(world, { kind: "road", at }, { ...road, points, sections }),
    docks: world.docks.map((dock) => (dock.road === road.name ? { ...dock, at_mm: on(dock.at_mm) } : dock)),
    starts: world.starts.map((start) =>
      start.at === "road" && start.road === road.name ? { ...start, at_mm: on(start.at_mm) } : start,
    ),
  };
}

/** The world with other corners for a floor, a line or a road. */
export function withPoints(world: OwnWorld, thing: Thing, points: Corner[]): OwnWorld {
  if (thing.kind === "road") return reshaped(world, thing.at, points);
  const part = partOf(world, thing);
  return part !== undefined && "points" in part ? withPart(world, thing, { ...part, points }) : world;
}

/** The road opened or closed, cuts and docks as in `withPoints`. */
export function withClosed(world: OwnWorld, at: number, closed: boolean): OwnWorld {
  const road = world.roads[at];
  if (road === undefined) return world;
  return reshaped(withPart(world, { kind: "road", at }, { ...road, closed }), at, [...road.points]);
}

/** The road cut into so many sections: cuts are taken from its end, or put into its longest section. */
export function withSections(world: OwnWorld, at: number, count: number): OwnWorld {
  const road = world.roads[at];
  const length = road === undefined ? 0 : (lineOf(road.points, road.closed)?.length ?? 0);
  if (road === undefined || length === 0) return world;
  let cuts = road.sections.map((section) => ({ sign: section.sign, from: section.from_mm }));
  if (count <= 0) cuts = [];
  else if (cuts.length === 0) cuts = [{ sign: 0, from: 0 }];
  while (cuts.length > Math.max(count, 0)) cuts.pop();
  while (cuts.length < count) {
    const ends = cuts.map((one, index) => (cuts[index + 1]?.from ?? length) - one.from);
    const widest = ends.indexOf(Math.max(...ends));
    const sign = Math.max(...cuts.map((one) => one.sign)) + 1;
    cuts.splice(widest + 1, 0, { sign, from: tidy((cuts[widest]?.from ?? 0) + (ends[widest] ?? 0) / 2) });
  }
  const sections = cuts.map(({ sign, from }, index) => ({
    sign,
    from_mm: from,
    to_mm: cuts[index + 1]?.from ?? null,
  }));
  return withPart(world, { kind: "road", at }, { ...road, sections });
}

/** The cut before a section of that number, from 1, somewhere else between its neighbours. */
export function withCut(world: OwnWorld, at: number, cut: number, mm: number): OwnWorld {
  const road = world.roads[at];
  const [before, after] = [road?.sections[cut - 1], road?.sections[cut]];
  if (road === undefined || before === undefined || after === undefined) return world;
  const end = after.to_mm ?? lineOf(road.points, road.closed)?.length ?? mm;
  const from = tidy(Math.min(Math.max(mm, before.from_mm + 1), end - 1));
  const sections = road.sections.map((section, index) =>
    index === cut - 1 ? { ...section, to_mm: from } : index === cut ? { ...section, from_mm: from } : section,
  );
  return withPart(world, { kind: "road", at }, { ...road, sections });
}

// -- grips

export interface Grip {
  /** "end:0", "corner:2", "cut:1", "size", "heading", "at". */
  id: string;
  x: number;
  y: number;
}

/** How far before a robot its heading is taken hold of. */
export const HEADING_MM = 110;

/** The places by which a thing is changed. */
export function gripsOf(world: OwnWorld, thing: Thing): Grip[] {
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

/** The world with a grip of a thing brought to a place. */
export function dragged(world: OwnWorld, thing: Thing, grip: string, x: number, y: number): OwnWorld {
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
    default:
      return world;
  }
}

// -- moving

/** How far from a road somebody is dropped and still starts on it, beyond its edge. */
const ROAD_REACH_MM = 60;

/** The start of that number somewhere else: on a road it stays on a road while it is dropped near one, at docks at a dock. */
export function startMoved(world: OwnWorld, at: number, x: number, y: number): OwnWorld {
  const start = world.starts[at];
  if (start === undefined) return world;
  const thing: Thing = { kind: "start", at };
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
  const [near] = world.roads
    .flatMap((road) => {
      const line = lineOf(road.points, road.closed);
      return line === null ? [] : [{ road, ...nearestOn(line, x, y) }];
    })
    .sort((a, b) => a.off - b.off);
  if (near !== undefined && near.off <= near.road.width_mm / 2 + ROAD_REACH_MM) {
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
export function anchorOf(world: OwnWorld, { kind, at }: Thing): { x: number; y: number } | null {
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
  }
}

/** The world with a thing so many mm further; docks, and starts on a road, move along it. */
export function moved(world: OwnWorld, thing: Thing, dx: number, dy: number): OwnWorld {
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
  }
}

// -- finding

const DOCK_MM = 70;
const ROBOT_MM = 55;

function offThing(world: OwnWorld, thing: Thing, x: number, y: number): number {
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
  }
}

const ON_TOP: readonly Kind[] = ["start", "wall", "dock", "storehouse", "line", "road", "floor"];

/** What lies at a place, at most `reach` mm off: what is drawn on top comes first. */
export function thingAt(world: OwnWorld, x: number, y: number, reach: number): Thing | null {
  for (const kind of ON_TOP) {
    const near = partsOfKind(world, kind)
      .map((_, at) => ({ at, off: offThing(world, { kind, at }, x, y) }))
      .filter(({ off }) => off <= (kind === "floor" ? 0 : reach))
      .sort((a, b) => a.off - b.off || b.at - a.at)[0];
    if (near !== undefined) return { kind, at: near.at };
  }
  return null;
}

// -- snapping

/** The ends of walls and lines that something dragged may take hold of. */
export function endsOf(world: OwnWorld, but: readonly Thing[]): { x: number; y: number }[] {
  const kinds: Kind[] = ["wall", "floor", "line", "road"];
  return kinds.flatMap((kind) =>
    partsOfKind(world, kind).flatMap((_, at) =>
      but.some((one) => sameThing(one, { kind, at }))
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
