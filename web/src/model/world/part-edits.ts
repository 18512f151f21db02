/**
 * The things of a mission's own world: the world with one of them changed, put in or taken out.
 *
 * A thing is a kind and its number from 0, as the server's problems name it. Pure: worlds are never changed in place.
 * Left to others: the shape of roads (`roads.ts`), dragging (`grips.ts`, `part-movement.ts`), what lies where (`hit-test.ts`),
 * commands and names that the mission uses (`commands/changeOwnWorld.ts`), what is allowed (the server).
 */
import type { OwnWorld } from "../types";
import { type AnyPart, FIELD, type Kind, KINDS, partsOfKind, isSamePart, type PartReference } from "./part-reference";

function withParts(world: OwnWorld, kind: Kind, parts: readonly AnyPart[]): OwnWorld {
  return { ...world, [FIELD[kind]]: parts };
}

/** The world with something else in the place of a thing. */
export function withPart(world: OwnWorld, { kind, at }: PartReference, part: AnyPart): OwnWorld {
  const parts = partsOfKind(world, kind).map((one, index) => (index === at ? part : one));
  return withParts(world, kind, parts);
}

export function added(world: OwnWorld, kind: Kind, part: AnyPart): { world: OwnWorld; thing: PartReference } {
  const parts = partsOfKind(world, kind);
  return { world: withParts(world, kind, [...parts, part]), thing: { kind, at: parts.length } };
}

/** `things`, and what cannot be without them: docks of a road or storehouse, starts on them. */
export function withDependents(world: OwnWorld, things: readonly PartReference[]): PartReference[] {
  const names = (kind: "road" | "storehouse" | "dock", of: readonly PartReference[]) =>
    of.flatMap((thing) => (thing.kind === kind ? [partsOfKind(world, kind)[thing.at]?.name ?? ""] : []));
  const found = [...things];
  const add = (kind: Kind, at: number) => {
    if (!found.some((one) => isSamePart(one, { kind, at }))) found.push({ kind, at });
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

export function removed(world: OwnWorld, things: readonly PartReference[]): OwnWorld {
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
