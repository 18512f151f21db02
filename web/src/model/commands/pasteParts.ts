/** Puts the blocks of a piece, with ids of their own, where they are pasted. */
import { t } from "../../i18n/words";
import type { Command } from "../command";
import { blocksOf } from "../fragment";
import { type Parts, title } from "../parts";
import { copyBlock, freshIds, type Place } from "../tree";
import type { Program } from "../types";
import { editStructure } from "./edit";
import { accepts, put, shown } from "./moveParts";

/** The command, or null when the piece is empty or cannot stand there. */
export function pasteParts(program: Program, parts: Parts, place: Place, piece: Program): Command | null {
  const blocks = blocksOf(piece, parts);
  const [first] = blocks;
  if (first === undefined) return null;
  const name = blocks.length === 1 ? title(first.shape) : t("command.parts");
  return editStructure(t("command.paste", { name }), program, parts, (structure) => {
    const nextId = freshIds(structure);
    const copies = blocks.map((block) => copyBlock(block, nextId));
    return accepts(structure, place, copies) && put(structure, place, copies) && copies.map(shown);
  });
}
