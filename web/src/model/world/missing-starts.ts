/** A world to begin with, made fit for the robots of a mission. */
import type { OwnWorld } from "../types";

/** Robots that find no start stand side by side in the middle, so far apart. */
const APART_MM = 160;

/** The world with a start for each name: its own starts become those that are missing, in order, before new ones are made. */
export function withStartsFor(world: OwnWorld, names: readonly string[]): OwnWorld {
  const missing = [...new Set(names)].filter((name) => !world.starts.some((start) => start.name === name));
  if (missing.length === 0) return world;
  const starts = world.starts.map((start) =>
    names.includes(start.name) ? start : { ...start, name: missing.shift() ?? start.name },
  );
  const more = missing.map((name, at) => ({
    name,
    at: "pose" as const,
    road: "",
    at_mm: 0,
    dock: "",
    storehouse: "",
    x_mm: Math.min(Math.round(world.width_mm / 2 + at * APART_MM), world.width_mm),
    y_mm: Math.round(world.height_mm / 2),
    heading_deg: 0,
  }));
  return { ...world, starts: [...starts, ...more] };
}
