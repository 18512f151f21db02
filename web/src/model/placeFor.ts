/**
 * Where a part goes when no place is pointed at: into the empty body of the selected vertex, after that vertex, on the
 * selected arc, into the first empty slot that it fits, else at the end of the program; what fits nowhere is parked.
 */
import { fits, isMark, type Shape, standsInChain } from "./parts";
import type { Block, Structure } from "./structure";
import { branchOwner, canMark, everySpot, findSpot, inChain, type Place, type Spot, withMark } from "./tree";

/** What is selected: a vertex, an arc by the port it leaves, or nothing. */
export interface Around {
  vertex: string | null;
  arc: { source: string; out: string } | null;
}

/**
 * The place, or null when there is none (a branch without a constructor to add it to). `waits`: where no slot fits a test,
 * the program waits for it at the selected arc, or after the selected vertex.
 */
export function placeFor(structure: Structure, around: Around, shape: Shape, waits = false): Place | null {
  const spot = around.vertex === null ? undefined : findSpot(structure, around.vertex);
  if (shape.role === "branch") return branchPlace(structure, spot, shape);
  if (!standsInChain(shape)) {
    // An arc is selected to put something there.
    const slot = waits && around.arc !== null ? null : slotPlace(structure, spot, shape);
    if (slot !== null) return slot;
    if (!waits || (around.arc === null && spot === undefined)) return { kind: "void" };
  }
  if (around.arc !== null) return arcPlace(around.arc.source, around.arc.out);
  if (spot !== undefined) {
    const action = emptySlot(spot.block, shape);
    if (action !== null) return action;
    if (isMark(shape) && withMark(spot) === spot && canMark(spot))
      return { kind: "vertex", vertex: spot.block.vertex.id };
    // What has an empty body wants its body first.
    const [body] = spot.block.bodies;
    if (spot.kind === "chain" && body?.chain.length === 0) return arcPlace(spot.block.vertex.id, body.out);
    return arcPlace(inChain(spot).block.vertex.id);
  }
  if (around.vertex !== null && around.vertex === structure.start?.id) return arcPlace(around.vertex);
  const last = structure.main.chain.at(-1)?.vertex.id ?? structure.start?.id;
  return last === undefined ? { kind: "void" } : arcPlace(last);
}

function arcPlace(source: string, out = "next"): Place & { kind: "arc" } {
  return { kind: "arc", source, out };
}

function branchPlace(structure: Structure, spot: Spot | undefined, shape: Shape): Place | null {
  let owner = spot === undefined ? undefined : branchOwner(spot, shape);
  if (spot === undefined) {
    everySpot(structure, ({ block }) => {
      if (block.shape.element === shape.constructor_?.adds?.constructor) owner ??= block;
    });
  }
  return owner === undefined ? null : { kind: "vertex", vertex: owner.vertex.id };
}

function slotPlace(structure: Structure, spot: Spot | undefined, shape: Shape): Place | null {
  if (spot === undefined) {
    let found: Place | null = null;
    everySpot(structure, ({ block }) => {
      found ??= emptySlot(block, shape);
    });
    return found;
  }
  const empty = emptySlot(spot.block, shape);
  if (empty !== null) return empty;
  // A selected test is replaced, or taken into a joining one; a full vertex has its first fitting slot refilled.
  if (spot.kind === "slot" && fitsSlot(spot.owner.block, spot.slot, shape)) {
    return { kind: "slot", vertex: spot.owner.block.vertex.id, slot: spot.slot };
  }
  const slot = spot.block.plugs.find((plug) => fitsSlot(spot.block, plug.slot, shape))?.slot;
  return slot === undefined ? null : { kind: "slot", vertex: spot.block.vertex.id, slot };
}

/** The first empty slot of a block, or of what fills its slots, that the part fits; typed numbers stay. */
function emptySlot(block: Block, shape: Shape): (Place & { kind: "slot" }) | null {
  for (const { slot, block: filler } of block.plugs) {
    const typed = block.shape.fields.some((field) => field.name === slot);
    if (filler === null && !typed && fitsSlot(block, slot, shape))
      return { kind: "slot", vertex: block.vertex.id, slot };
    const inner = filler === null ? null : emptySlot(filler, shape);
    if (inner !== null) return inner;
  }
  return null;
}

function fitsSlot(owner: Block, slot: string, shape: Shape): boolean {
  const plug = owner.shape.plugs.find((one) => one.name === slot);
  return plug !== undefined && fits(shape, plug);
}
