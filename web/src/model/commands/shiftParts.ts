/** Moves a stretch of a chain one place up or down; past the end of its body it comes out of what holds it. */
import type { Command } from "../command";
import type { Parts } from "../parts";
import { readStructure, type Structure } from "../structure";
import { findSpot, inChain, type Place, type Spot } from "../tree";
import type { Program } from "../types";
import { moveParts } from "./moveParts";
import { stretchOf } from "./wrapParts";

/** The command, or null when they do not stand in one chain or there is nothing to move past. */
export function shiftParts(program: Program, parts: Parts, ids: readonly string[], by: 1 | -1): Command | null {
  const structure = readStructure(program, parts);
  const stretch = stretchOf(structure, ids);
  const id = stretch?.chain[stretch.from]?.vertex.id;
  const spot = id === undefined ? undefined : findSpot(structure, id);
  if (stretch === null || spot?.kind !== "chain") return null;
  const place = by < 0 ? before(structure, spot, stretch.from) : after(spot, stretch.to);
  return place === null ? null : moveParts(program, parts, [...ids], place);
}

function before(structure: Structure, { chain, body, owner }: Spot & { kind: "chain" }, from: number): Place | null {
  if (from > 0) return arcInto(structure, { chain, body, owner }, from - 1);
  if (owner === null) return null;
  const outer = inChain(owner);
  return arcInto(structure, outer, outer.index);
}

function after({ chain, owner }: Spot & { kind: "chain" }, to: number): Place | null {
  const next = chain[to + 1] ?? (owner === null ? undefined : inChain(owner).block);
  return next === undefined ? null : { kind: "arc", source: next.vertex.id, out: "next" };
}

/** The arc that leads to the block at that index. */
function arcInto(
  structure: Structure,
  { chain, body, owner }: Pick<Spot & { kind: "chain" }, "chain" | "body" | "owner">,
  index: number,
): Place | null {
  const source = index > 0 ? chain[index - 1]?.vertex.id : (owner?.block.vertex.id ?? structure.start?.id);
  if (source === undefined || body === null) return null;
  return { kind: "arc", source, out: index > 0 ? "next" : body.out };
}
