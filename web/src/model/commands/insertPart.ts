/** Puts a new part where it was dropped: on an arc, in a slot, on a vertex, or on the void, where it is parked. */
import { t } from "../../i18n/words";
import type { Command } from "../command";
import { fits, isMark, type Parts, type Shape, standsInChain, title, waitingFor } from "../parts";
import type { Structure } from "../structure";
import {
  branchOwner,
  canMark,
  findSpot,
  freshIds,
  growBranch,
  newBlock,
  park,
  type Place,
  plugIn,
  spliceIn,
  withMark,
  wrapInMark,
} from "../tree";
import type { Program } from "../types";
import { editStructure } from "./edit";

/** The command, or null when that part cannot stand there. */
export function insertPart(program: Program, parts: Parts, place: Place, element: string): Command | null {
  const shape = parts.shape(element);
  return editStructure(t("command.add", { name: title(shape) }), program, parts, (structure) =>
    insert(structure, parts, place, shape),
  );
}

function insert(structure: Structure, parts: Parts, place: Place, shape: Shape): string[] | false {
  if (shape.role === "branch") return insertBranch(structure, place, shape);
  const fresh = freshIds(structure);
  const block = newBlock(shape, fresh());
  const created = [block.vertex.id];
  switch (place.kind) {
    case "void":
      park(structure, [block]);
      return created;
    case "arc": {
      if (standsInChain(shape)) return spliceIn(structure, place, [block]) && created;
      const holder = waitingFor(parts, shape);
      const [plug] = holder?.plugs ?? [];
      if (holder === undefined || plug === undefined) return false;
      const wait = newBlock(holder, fresh());
      return plugIn(wait, plug.name, block) && spliceIn(structure, place, [wait]) && created;
    }
    case "slot": {
      const owner = findSpot(structure, place.vertex)?.block;
      const plug = owner?.shape.plugs.find((one) => one.name === place.slot);
      if (owner === undefined || plug === undefined || !fits(shape, plug)) return false;
      return plugIn(owner, place.slot, block) && created;
    }
    case "vertex": {
      const spot = findSpot(structure, place.vertex);
      if (spot === undefined || !isMark(shape) || withMark(spot) !== spot || !canMark(spot)) return false;
      wrapInMark(spot, block);
      return [spot.block.vertex.id];
    }
  }
}

function insertBranch(structure: Structure, place: Place, shape: Shape): string[] | false {
  const adds = shape.constructor_?.adds;
  if (place.kind !== "vertex" || adds == null) return false;
  const spot = findSpot(structure, place.vertex);
  const owner = spot === undefined ? undefined : branchOwner(spot, shape);
  if (owner === undefined) return false;
  growBranch(owner, adds.slot);
  return [owner.vertex.id];
}
