/** What a tool makes: a thing between the two places where it was drawn, with names and numbers that are free. */
import { freeName } from "../free-name";
import type { OwnWorld } from "../types";
import { nearestRoad } from "./roads";
import { type Kind, type Part, partsOfKind, type PartReference, tidy } from "./part-reference";
import { added } from "./part-edits";

export interface Spot {
  x: number;
  y: number;
}

const LEAST_MM = 20;
const SIZE: Record<Kind, [number, number]> = {
  wall: [300, 0],
  floor: [150, 150],
  line: [300, 0],
  road: [500, 300],
  storehouse: [180, 240],
  dock: [0, 0],
  start: [0, 0],
  box: [80, 80],
  ball: [60, 60],
  zone: [400, 400],
};

/** `stem-1`, `stem-2`, …, or A, B, C for storehouses and docks: the first that is free. */
function nameFor(kind: "road" | "storehouse" | "dock" | "start", world: OwnWorld): string {
  const taken = new Set(partsOfKind(world, kind).map((part) => part.name));
  if (kind === "storehouse" || kind === "dock") {
    const letter = [..."ABCDEFGHIJKLMNOPQRSTUVWXYZ"].find((one) => !taken.has(one));
    if (letter !== undefined) return letter;
  }
  return freeName(kind === "start" ? "robot" : kind, [...taken]);
}

function box(a: Spot, b: Spot): { x: number; y: number; width: number; height: number } {
  const [x, y] = [Math.min(a.x, b.x), Math.min(a.y, b.y)];
  return { x, y, width: Math.max(Math.abs(b.x - a.x), LEAST_MM), height: Math.max(Math.abs(b.y - a.y), LEAST_MM) };
}

function made(world: OwnWorld, kind: Kind, a: Spot, b: Spot): Part<Kind> | null {
  const corner = (x: number, y: number, radius = 0) => ({ x: tidy(x), y: tidy(y), radius: tidy(radius) });
  const { x, y, width, height } = box(a, b);
  const middle = { x_mm: tidy(x + width / 2), y_mm: tidy(y + height / 2) };
  const round = tidy(Math.max(width, height) / 2);
  switch (kind) {
    case "wall":
      return { x1: tidy(a.x), y1: tidy(a.y), x2: tidy(b.x), y2: tidy(b.y) };
    case "line":
      return { colour: "blue", width_mm: 20, closed: false, points: [corner(a.x, a.y), corner(b.x, b.y)] };
    case "floor":
      return {
        colour: "green",
        points: [corner(x, y), corner(x + width, y), corner(x + width, y + height), corner(x, y + height)],
      };
    case "road": {
      // Round as people draw roads: a ring through the corners of what was drawn.
      const radius = Math.min(width, height) / 3;
      const points = [
        corner(x, y + height / 2),
        corner(x, y + height, radius),
        corner(x + width, y + height, radius),
        corner(x + width, y, radius),
        corner(x, y, radius),
      ];
      const sections = [{ sign: 0, from_mm: 0, to_mm: null }];
      return { name: nameFor("road", world), width_mm: 125, closed: true, points, sections };
    }
    case "storehouse":
      return {
        name: nameFor("storehouse", world),
        x_mm: tidy(x),
        y_mm: tidy(y),
        width_mm: tidy(width),
        height_mm: tidy(height),
        capacity: 12,
        stock: 0,
      };
    case "dock": {
      const near = nearestRoad(world, a.x, a.y);
      const house = [...world.storehouses].sort(
        (one, other) =>
          Math.hypot(one.x_mm + one.width_mm / 2 - a.x, one.y_mm + one.height_mm / 2 - a.y) -
          Math.hypot(other.x_mm + other.width_mm / 2 - a.x, other.y_mm + other.height_mm / 2 - a.y),
      )[0];
      if (near === null || house === undefined) return null;
      return {
        name: nameFor("dock", world),
        road: near.road.name,
        at_mm: Math.round(near.at),
        reach_mm: 30,
        storehouse: house.name,
        kind: house.stock > 0 ? "load" : "unload",
        side: "left",
      };
    }
    case "start": {
      const near = nearestRoad(world, a.x, a.y);
      const there = near !== null && near.off <= near.road.width_mm / 2;
      return {
        name: nameFor("start", world),
        at: there ? "road" : "pose",
        road: there ? near.road.name : "",
        at_mm: there ? Math.round(near.at) : 0,
        dock: "",
        storehouse: "",
        x_mm: there ? 0 : tidy(a.x),
        y_mm: there ? 0 : tidy(a.y),
        heading_deg: 0,
      };
    }
    case "box":
      return { ...middle, width_mm: tidy(width), height_mm: tidy(height), mass_g: 200, friction: 0.5 };
    case "ball":
      return { ...middle, radius_mm: round, mass_g: 50, friction: 0.02 };
    case "zone":
      return { kind: "warm", ...middle, radius_mm: round, width_mm: 0, height_mm: 0, value: 35, falloff_mm: 200 };
  }
}

/**
 * The world with a new thing, drawn from one place to another; a press without a drag (`to` null) gives it a usual size.
 * Null where it cannot be: a dock without a road or a storehouse.
 */
export function drawNew(
  world: OwnWorld,
  kind: Kind,
  from: Spot,
  to: Spot | null,
): { world: OwnWorld; thing: PartReference } | null {
  const [width, height] = SIZE[kind];
  const a = to === null ? { x: from.x - width / 2, y: from.y - height / 2 } : from;
  const b = to ?? { x: from.x + width / 2, y: from.y + height / 2 };
  const part = made(world, kind, kind === "start" || kind === "dock" ? from : a, b);
  return part === null ? null : added(world, kind, part);
}
