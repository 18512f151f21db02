/** Adds a branch to a constructor with a repeated slot, or takes one away. */
import { t } from "../../i18n/words";
import type { Command } from "../command";
import { type Parts, shortTitle } from "../parts";
import { dropBranch, findSpot, growBranch } from "../tree";
import type { Program } from "../types";
import { editStructure } from "./edit";

/** One more branch at the end of the first repeated slot, or null when the vertex has none. */
export function addBranch(program: Program, parts: Parts, id: string): Command | null {
  const shape = parts.shape(program.vertices.find((one) => one.id === id)?.element ?? "");
  return editStructure(t("command.add-branch", { name: shortTitle(shape) }), program, parts, (structure) => {
    const block = findSpot(structure, id)?.block;
    const flow = block?.shape.flows.find((one) => one.repeat);
    if (block === undefined || flow === undefined) return false;
    growBranch(block, flow.name);
    return undefined;
  });
}

/** Without that branch (by its out-port) and what stands in it, or null when it is not there or one must stay. */
export function removeBranch(program: Program, parts: Parts, id: string, out: string): Command | null {
  return editStructure(t("command.remove-branch"), program, parts, (structure) => {
    const block = findSpot(structure, id)?.block;
    const flow = block?.shape.flows.find((one) => one.repeat && out.startsWith(`${one.name}.`));
    if (block === undefined || flow === undefined || !block.bodies.some((body) => body.out === out)) return false;
    const count = block.bodies.filter((body) => body.out.startsWith(`${flow.name}.`)).length;
    if (count <= 1) return false;
    dropBranch(block, out);
    return undefined;
  });
}
