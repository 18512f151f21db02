/** Moves vertices with all they hold to another place, or puts copies of them there. */
import { t } from "../../i18n/words";
import type { Command } from "../command";
import { fits, isMark, type Parts, standsInChain, title } from "../parts";
import type { Block, Structure } from "../structure";
import {
  chainAt,
  copyBlock,
  findSpot,
  freshIds,
  park,
  type Place,
  plugIn,
  type Spot,
  spliceIn,
  takeOut,
  topmost,
  withMark,
} from "../tree";
import type { Mission, Program } from "../types";
import { editStructure } from "./edit";

/** The command, or null when they cannot go there (for one, into their own body). */
export function moveParts(program: Program, parts: Parts, ids: string[], place: Place): Command | null {
  const command = editStructure(named("command.move", program, parts, ids), program, parts, (structure) => {
    const spots = topmost(structure, ids).map(withMark);
    if (spots.length === 0 || holds(spots, place)) return false;
    const blocks = spots.map((spot) => spot.block);
    if (!accepts(structure, place, blocks)) return false;
    return place.kind === "arc" ? moveToArc(structure, spots, place) : moveElsewhere(structure, spots, place);
  });
  return command !== null && changes(command, program) ? command : null;
}

/** Whether the command leaves another program than it found: a vertex dropped where it was does not. */
function changes(command: Command, program: Program): boolean {
  const mission: Mission = { version: 1, programs: [program], agents: [], goals: [], world: "" };
  return JSON.stringify(command.execute(mission).programs[0]?.arcs) !== JSON.stringify(program.arcs);
}

/** The command that puts a copy of the vertices there. */
export function copyParts(program: Program, parts: Parts, ids: string[], place: Place): Command | null {
  return editStructure(named("command.copy", program, parts, ids), program, parts, (structure) => {
    const nextId = freshIds(structure);
    const copies = topmost(structure, ids)
      .map(withMark)
      .map((spot) => copyBlock(spot.block, nextId));
    if (copies.length === 0 || !accepts(structure, place, copies)) return false;
    return put(structure, place, copies) && copies.map(shown);
  });
}

/** The vertex that stands for a block on the screen: a mark shows as its action. */
export function shown(block: Block): string {
  return (isMark(block.shape) ? block.plugs[0]?.block : null)?.vertex.id ?? block.vertex.id;
}

function named(key: "command.move" | "command.copy", program: Program, parts: Parts, ids: string[]): string {
  const only = ids.length === 1 ? program.vertices.find((one) => one.id === ids[0]) : undefined;
  return t(key, { name: only === undefined ? t("command.parts") : title(parts.shape(only.element)) });
}

/** Whether the place is inside one of the blocks that are to move. */
function holds(spots: Spot[], place: Place): boolean {
  if (place.kind === "void") return false;
  const id = place.kind === "arc" ? place.source : place.vertex;
  return spots.some((spot) => {
    if (spot.block.vertex.id === id) return place.kind !== "arc" || place.out !== "next";
    return insideOf(spot.block, id);
  });
}

function insideOf(block: Block, id: string): boolean {
  const held = [...block.plugs.map((plug) => plug.block), ...block.bodies.flatMap((body) => body.chain)];
  return held.some((one) => one !== null && (one.vertex.id === id || insideOf(one, id)));
}

export function accepts(structure: Structure, place: Place, blocks: Block[]): boolean {
  switch (place.kind) {
    case "void":
      return true;
    case "arc":
      return (
        blocks.every((block) => standsInChain(block.shape)) && chainAt(structure, place.source, place.out) !== undefined
      );
    case "slot": {
      const [block] = blocks;
      const owner = findSpot(structure, place.vertex)?.block;
      const plug = owner?.shape.plugs.find((one) => one.name === place.slot);
      return blocks.length === 1 && block !== undefined && plug !== undefined && fits(block.shape, plug);
    }
    case "vertex":
      return false;
  }
}

/** The arc may leave a block that moves itself, so its place is held by a stand-in while blocks are taken out. */
function moveToArc(structure: Structure, spots: Spot[], place: Place & { kind: "arc" }): string[] | false {
  const at = chainAt(structure, place.source, place.out);
  if (at === undefined) return false;
  const before = at.chain.slice(0, at.index);
  const moving = new Set(spots.map((spot) => spot.block));
  const index = before.filter((block) => !moving.has(block)).length;
  for (const spot of spots) takeOut(structure, spot);
  const blocks = [...moving];
  at.chain.splice(index, 0, ...blocks);
  if (at.body !== null && at.chain.at(-1) === blocks.at(-1) && !at.body.closed) {
    at.body.closed = at.body !== structure.main || structure.stop !== null;
  }
  if (at.body === null && !structure.parked.includes(at.chain)) structure.parked.push(at.chain);
  return blocks.map(shown);
}

function moveElsewhere(structure: Structure, spots: Spot[], place: Place): string[] | false {
  for (const spot of spots) takeOut(structure, spot);
  const blocks = spots.map((spot) => spot.block);
  return put(structure, place, blocks) && blocks.map(shown);
}

export function put(structure: Structure, place: Place, blocks: Block[]): boolean {
  const [block] = blocks;
  if (block === undefined) return false;
  switch (place.kind) {
    case "arc":
      return spliceIn(structure, place, blocks);
    case "slot": {
      const owner = findSpot(structure, place.vertex)?.block;
      return owner !== undefined && plugIn(owner, place.slot, block);
    }
    case "void": {
      const chained = blocks.filter((one) => standsInChain(one.shape));
      park(structure, chained);
      for (const one of blocks) if (!standsInChain(one.shape)) park(structure, [one]);
      return true;
    }
    case "vertex":
      return false;
  }
}
