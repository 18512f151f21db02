/** Puts a mark around an action, or takes it off: the badge on the vertex. */
import type { Command } from "../command";
import { type Parts, shortTitle } from "../parts";
import { canMark, findSpot, freshIds, markAround, newBlock, wrapInMark } from "../tree";
import type { Program } from "../types";
import { editStructure } from "./edit";

/** The command for the action vertex `id` and the marking constructor `element`, or null when it cannot be marked. */
export function toggleMark(program: Program, parts: Parts, id: string, element: string): Command | null {
  const shape = parts.shape(element);
  return editStructure(shortTitle(shape), program, parts, (structure) => {
    const spot = findSpot(structure, id);
    if (spot === undefined) return false;
    const around = markAround(spot);
    if (around === undefined) {
      if (!canMark(spot)) return false;
      wrapInMark(spot, newBlock(shape, freshIds(structure)()));
      return undefined;
    }
    if (around.block.shape.element !== element || around.kind !== "chain") return false;
    around.chain[around.index] = spot.block;
    return undefined;
  });
}
