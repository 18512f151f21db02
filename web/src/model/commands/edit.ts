/** The frame of every command that changes one program: read, change the tree, write. */
import { type Command, replaceProgram } from "../command";
import type { Parts } from "../parts";
import { readStructure, type Structure, writeStructure } from "../structure";
import type { Program } from "../types";

/**
 * The command for a change of the tree; null when `change` says (by false) that there is nothing to do.
 *
 * `change` gives the ids to select afterwards, or undefined to leave the selection.
 */
export function editStructure(
  label: string,
  program: Program,
  parts: Parts,
  change: (structure: Structure) => string[] | undefined | false,
): Command | null {
  const structure = readStructure(program, parts);
  const selects = change(structure);
  if (selects === false) return null;
  return replaceProgram(label, program, writeStructure(structure), selects);
}
