/** Roads that change their shape: corners, closed or open, sections and the cuts between them. */
import type { Corner, OwnWorld } from "../types";
import { lineOf } from "./drawing";
import { nearestOn } from "./line";
import { type Part, partOf, type PartReference, tidy } from "./part-reference";
import { withPart } from "./part-edits";

/** The road nearest to a place, how far along it (mm) and how far off it is; null without roads. */
export function nearestRoad(
  world: OwnWorld,
  x: number,
  y: number,
): { road: Part<"road">; at: number; off: number } | null {
  const [near] = world.roads
    .flatMap((road) => {
      const line = lineOf(road.points, road.closed);
      return line === null ? [] : [{ road, ...nearestOn(line, x, y) }];
    })
    .sort((a, b) => a.off - b.off);
  return near ?? null;
}

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
export function withPoints(world: OwnWorld, thing: PartReference, points: Corner[]): OwnWorld {
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
