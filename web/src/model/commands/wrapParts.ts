/**
 * Puts a constructor around a stretch of a chain, or takes one away and leaves what it held in its place.
 *
 * A constructor wraps by its first slot that holds a chain; one that holds several gives up all of them, one after the
 * other, when it is unwrapped.
 */
import { t } from "../../i18n/words";
import type { Command } from "../command";
import { isMark, type Parts, type Shape, shortTitle, standsInChain } from "../parts";
import type { Block, Structure } from "../structure";
import { findSpot, freshIds, inChain, newBlock, topmost } from "../tree";
import type { Program, Vertex } from "../types";
import { editStructure } from "./edit";

/** Whether that part can go around others. */
export function wraps(shape: Shape): boolean {
  return standsInChain(shape) && shape.flows.length > 0;
}

/** The stretch of one chain from the first to the last of the vertices, or null when they stand in several. */
export function stretchOf(
  structure: Structure,
  ids: readonly string[],
): { chain: Block[]; from: number; to: number } | null {
  const spots = topmost(structure, [...ids]).map(inChain);
  const [first] = spots;
  if (first === undefined || spots.some((spot) => spot.chain !== first.chain)) return null;
  if (spots.some((spot) => !standsInChain(spot.block.shape))) return null;
  const indices = spots.map((spot) => spot.index);
  return { chain: first.chain, from: Math.min(...indices), to: Math.max(...indices) };
}

/** The command, or null when the vertices do not stand in one chain or the part holds none. */
export function wrapParts(program: Program, parts: Parts, ids: readonly string[], element: string): Command | null {
  const shape = parts.shape(element);
  if (!wraps(shape)) return null;
  return editStructure(t("command.wrap", { name: shortTitle(shape) }), program, parts, (structure) => {
    const stretch = stretchOf(structure, ids);
    if (stretch === null) return false;
    const { chain, from, to } = stretch;
    const around = newBlock(shape, freshIds(structure)());
    const [body] = around.bodies;
    if (body === undefined) return false;
    body.chain = chain.splice(from, to - from + 1, around);
    return [around.vertex.id];
  });
}

/** What stands in the bodies of a block, and a marked action. */
function held(block: Block): Block[] {
  const action = isMark(block.shape) ? block.plugs[0]?.block : null;
  return action == null ? block.bodies.flatMap((body) => body.chain) : [action];
}

/** Notes of a block that goes stay with the first of what it held. */
function withNotes(vertex: Vertex, { notes }: Vertex): Vertex {
  return { ...vertex, notes: [...notes.filter((note) => note.at === ""), ...vertex.notes] };
}

/** The command, or null when that vertex holds no chain. */
export function unwrapPart(program: Program, parts: Parts, id: string): Command | null {
  const name = shortTitle(parts.shape(program.vertices.find((one) => one.id === id)?.element ?? ""));
  return editStructure(t("command.unwrap", { name }), program, parts, (structure) => {
    const spot = findSpot(structure, id);
    if (spot?.kind !== "chain" || (spot.block.bodies.length === 0 && !isMark(spot.block.shape))) return false;
    const blocks = held(spot.block);
    const [first] = blocks;
    if (first !== undefined) first.vertex = withNotes(first.vertex, spot.block.vertex);
    spot.chain.splice(spot.index, 1, ...blocks);
    structure.parked = structure.parked.filter((chain) => chain.length > 0);
    return blocks.map((block) => (isMark(block.shape) ? block.plugs[0]?.block : null)?.vertex.id ?? block.vertex.id);
  });
}
