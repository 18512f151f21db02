/**
 * A mission's own world as the arena draws it: what the server would say of the same world.
 *
 * So an edit is seen at once. What cannot be drawn as it is (a radius without room) is drawn with straight corners, and
 * what has no place (a dock of a road that is not there) is left out; the server's check says what is wrong.
 */
import type { Corner, OwnWorld, World } from "../types";
import { type Line, lineThrough, normalised, type Place, placeAt } from "./line";

const ARM_CLEARANCE_MM = 40;

const lines = new WeakMap<readonly Corner[], [closed: boolean, line: Line | null]>();

/** The line through corners, worked out once for the same ones; with straight corners where the radii have no room. */
export function lineOf(points: readonly Corner[], closed: boolean): Line | null {
  const known = lines.get(points);
  if (known?.[0] === closed) return known[1];
  const line =
    lineThrough(points, closed) ??
    lineThrough(
      points.map((point) => ({ ...point, radius: 0 })),
      closed,
    );
  lines.set(points, [closed, line]);
  return line;
}

export function roadLine(world: OwnWorld, name: string): Line | null {
  const road = world.roads.find((one) => one.name === name);
  return road === undefined ? null : lineOf(road.points, road.closed);
}

/** Where a carrier stands in the dock. */
export function dockPlace(world: OwnWorld, dock: OwnWorld["docks"][number]): Place | null {
  const line = roadLine(world, dock.road);
  return line === null ? null : placeAt(line, dock.at_mm);
}

/** The place of a start; null where the world has no such place. */
export function startPlace(world: OwnWorld, start: OwnWorld["starts"][number]): Place | null {
  switch (start.at) {
    case "pose":
      return { x: start.x_mm, y: start.y_mm, heading: normalised((start.heading_deg * Math.PI) / 180) };
    case "road": {
      const line = roadLine(world, start.road);
      return line === null ? null : placeAt(line, start.at_mm);
    }
    case "storehouse": {
      const house = world.storehouses.find((one) => one.name === start.storehouse);
      if (house === undefined) return null;
      return { x: house.x_mm + house.width_mm / 2, y: house.y_mm + house.height_mm / 2, heading: 0 };
    }
    case "dock": {
      const dock = world.docks.find((one) => one.name === start.dock);
      const road = world.roads.find((one) => one.name === dock?.road);
      const place = dock === undefined ? null : dockPlace(world, dock);
      if (dock === undefined || road === undefined || place === null) return null;
      const across = place.heading + (dock.side === "left" ? Math.PI / 2 : -Math.PI / 2);
      const away = road.width_mm / 2 + ARM_CLEARANCE_MM;
      return {
        x: place.x + away * Math.cos(across),
        y: place.y + away * Math.sin(across),
        heading: normalised(across + Math.PI),
      };
    }
  }
}

const drawn = new WeakMap<OwnWorld, World>();

const sized = ({ x_mm, y_mm }: { x_mm: number; y_mm: number }, width_mm: number, height_mm: number) => ({
  x_mm,
  y_mm,
  width_mm,
  height_mm,
});

/** The world as it is drawn; the same object for the same world. */
export function drawnWorld(own: OwnWorld): World {
  const known = drawn.get(own);
  if (known !== undefined) return known;
  const points = (corners: readonly Corner[], closed: boolean): [number, number][] =>
    lineOf(corners, closed)?.points ?? corners.map(({ x, y }) => [x, y]);
  const world: World = {
    name: own.name,
    width_mm: own.width_mm,
    height_mm: own.height_mm,
    walls: own.walls,
    floors: own.floors.map(({ colour, points: corners }) => ({ colour, points: points(corners, true) })),
    lines: own.lines.map((line) => ({ ...line, points: points(line.points, line.closed) })),
    roads: own.roads.map((road) => {
      const length = lineOf(road.points, road.closed)?.length ?? 0;
      const sections = road.sections.map((section) => ({ ...section, to_mm: section.to_mm ?? length }));
      return { ...road, points: points(road.points, road.closed), sections };
    }),
    docks: own.docks.flatMap((dock) => {
      const place = dockPlace(own, dock);
      if (place === null) return [];
      const { side: _, ...rest } = dock;
      return [{ ...rest, x_mm: place.x, y_mm: place.y, heading_rad: place.heading }];
    }),
    storehouses: own.storehouses,
    starts: own.starts.flatMap((start) => {
      const place = startPlace(own, start);
      return place === null ? [] : [{ name: start.name, x_mm: place.x, y_mm: place.y, heading_rad: place.heading }];
    }),
    things: [
      ...(own.boxes ?? []).map((box) => ({ ...sized(box, box.width_mm, box.height_mm), kind: "box" as const })),
      ...(own.balls ?? []).map((ball) => ({
        ...sized(ball, 2 * ball.radius_mm, 2 * ball.radius_mm),
        kind: "ball" as const,
      })),
    ],
    zones: own.zones ?? [],
  };
  drawn.set(own, world);
  return world;
}
