/**
 * Finding and changing things in a freshly read structure. Every function here may change the tree it is given; vertices
 * themselves are never changed, only replaced.
 */
import { isMark, type Shape, standsInChain } from "./parts";
import type { Block, Body, Structure } from "./structure";
import type { Vertex } from "./types";

/** Where a block stands: in a chain of a body (or of the void), or in a slot of another block. */
export type Spot =
  | { kind: "chain"; block: Block; chain: Block[]; index: number; body: Body | null; owner: Spot | null }
  | { kind: "slot"; block: Block; slot: string; owner: Spot };

/** A place where a part can be put. */
export type Place =
  | { kind: "arc"; source: string; out: string }
  | { kind: "slot"; vertex: string; slot: string }
  /** On the vertex itself: one more branch, or a mark around its action. */
  | { kind: "vertex"; vertex: string }
  | { kind: "void" };

/** Calls `visit` for every block, owners before what they hold, in reading order. */
export function everySpot(structure: Structure, visit: (spot: Spot) => void): void {
  const inBlock = (spot: Spot) => {
    visit(spot);
    for (const { slot, block } of spot.block.plugs) {
      if (block !== null) inBlock({ kind: "slot", block, slot, owner: spot });
    }
    for (const body of spot.block.bodies) inChain(body.chain, body, spot);
  };
  const inChain = (chain: Block[], body: Body | null, owner: Spot | null) => {
    chain.forEach((block, index) => {
      inBlock({ kind: "chain", block, chain, index, body, owner });
    });
  };
  inChain(structure.main.chain, structure.main, null);
  for (const chain of structure.parked) inChain(chain, null, null);
}

/** Where that vertex stands, or undefined for Start, Stop and what is not in the tree. */
export function findSpot(structure: Structure, id: string): Spot | undefined {
  let found: Spot | undefined;
  everySpot(structure, (spot) => {
    if (spot.block.vertex.id === id) found = spot;
  });
  return found;
}

/** The spot of the block that stands in a chain and holds this one in its slots (or is this one). */
export function inChain(spot: Spot): Spot & { kind: "chain" } {
  let at = spot;
  while (at.kind === "slot") at = at.owner;
  return at;
}

/** What moves or goes when this spot does: a marked action takes its mark along. */
export function withMark(spot: Spot): Spot {
  return spot.kind === "slot" && isMark(spot.owner.block.shape) ? spot.owner : spot;
}

/** The vertices of a block, itself first, in reading order. */
export function verticesOf(block: Block): Vertex[] {
  return [
    block.vertex,
    ...block.plugs.flatMap((plug) => (plug.block === null ? [] : verticesOf(plug.block))),
    ...block.bodies.flatMap((body) => body.chain.flatMap(verticesOf)),
  ];
}

/** Ids that no vertex has yet: v1, v2, … upwards from the highest in use. */
export function freshIds(structure: Structure): () => string {
  let highest = 0;
  const look = (id: string) => {
    const number = /^v([1-9][0-9]{0,8})$/.exec(id)?.[1];
    if (number !== undefined) highest = Math.max(highest, Number(number));
  };
  everySpot(structure, (spot) => {
    look(spot.block.vertex.id);
  });
  for (const vertex of [structure.start, structure.stop, ...structure.lost]) if (vertex !== null) look(vertex.id);
  for (const arc of structure.strays) {
    look(arc.source);
    look(arc.target);
  }
  return () => `v${String(++highest)}`;
}

/** A new block of that shape: defaults typed in, bodies closed, slots open. */
export function newBlock(shape: Shape, id: string): Block {
  const settings: Record<string, string> = {};
  for (const field of shape.fields) settings[field.name] = field.default;
  return {
    vertex: { id, element: shape.element, settings, notes: [] },
    shape,
    plugs: shape.plugs.map((plug) => ({ slot: plug.name, block: null })),
    bodies: shape.flows.flatMap((flow) =>
      flow.repeat
        ? Array.from({ length: Math.max(flow.least, 1) }, (_, at) => emptyBody(`${flow.name}.${String(at + 1)}`))
        : [emptyBody(flow.name)],
    ),
  };
}

export function emptyBody(out: string): Body {
  return { out, chain: [], closed: true };
}

/** A copy with ids of its own. */
export function copyBlock(block: Block, nextId: () => string): Block {
  return {
    vertex: { ...block.vertex, id: nextId() },
    shape: block.shape,
    plugs: block.plugs.map(({ slot, block: filler }) => ({
      slot,
      block: filler === null ? null : copyBlock(filler, nextId),
    })),
    bodies: block.bodies.map((body) => ({
      out: body.out,
      chain: body.chain.map((one) => copyBlock(one, nextId)),
      closed: body.closed,
    })),
  };
}

/** The chain and index that an arc stands for, or undefined for an arc that is not there. */
export function chainAt(
  structure: Structure,
  source: string,
  out: string,
): { chain: Block[]; index: number; body: Body | null } | undefined {
  if (structure.start?.id === source) return { chain: structure.main.chain, index: 0, body: structure.main };
  const spot = findSpot(structure, source);
  if (spot === undefined) return undefined;
  const body = spot.block.bodies.find((one) => one.out === out);
  if (body !== undefined) return { chain: body.chain, index: 0, body };
  // A parked test or value has no chain that could go on.
  if (out !== "next" || spot.kind !== "chain" || !standsInChain(spot.block.shape)) return undefined;
  return { chain: spot.chain, index: spot.index + 1, body: spot.body };
}

/** Puts blocks where an arc is; a body that did not arrive anywhere is closed by it when they become its end. */
export function spliceIn(structure: Structure, place: Place & { kind: "arc" }, blocks: Block[]): boolean {
  const at = chainAt(structure, place.source, place.out);
  if (at === undefined) return false;
  at.chain.splice(at.index, 0, ...blocks);
  if (at.body !== null && at.index + blocks.length === at.chain.length) close(structure, at.body);
  return true;
}

function close(structure: Structure, body: Body): void {
  if (body !== structure.main || structure.stop !== null) body.closed = true;
}

/** Takes a block out of where it stands; the arc heals, an open field shows its default again. */
export function takeOut(structure: Structure, spot: Spot): void {
  if (spot.kind === "chain") {
    const index = spot.chain.indexOf(spot.block);
    spot.chain.splice(index, 1);
    structure.parked = structure.parked.filter((chain) => chain.length > 0);
    return;
  }
  const owner = spot.owner.block;
  for (const plug of owner.plugs) if (plug.block === spot.block) plug.block = null;
  const field = owner.shape.fields.find((one) => one.name === spot.slot);
  if (field !== undefined) setField(owner, field.name, field.default);
}

/** Fills a slot. What stood there goes, except that a condition made of conditions takes it in. */
export function plugIn(owner: Block, slot: string, block: Block): boolean {
  const plug = owner.plugs.find((one) => one.slot === slot);
  if (plug === undefined) return false;
  const former = plug.block;
  const room = block.shape.role === "condition" ? block.plugs.find((one) => one.block === null) : undefined;
  const roomPlug = block.shape.plugs.find((one) => one.name === room?.slot);
  if (former !== null && room !== undefined && roomPlug?.accepts === "condition") room.block = former;
  plug.block = block;
  setField(owner, slot, undefined);
  return true;
}

/** Types into a field; undefined takes the setting away. */
export function setField(block: Block, name: string, value: string | undefined): void {
  const settings = { ...block.vertex.settings };
  if (value === undefined) delete settings[name];
  else settings[name] = value;
  block.vertex = { ...block.vertex, settings };
}

/** Puts a mark around the action of a spot, in its place. */
export function wrapInMark(spot: Spot, mark: Block): void {
  const plug = mark.plugs[0];
  if (plug === undefined) return;
  plug.block = spot.block;
  if (spot.kind === "chain") spot.chain[spot.chain.indexOf(spot.block)] = mark;
}

/** Whether the mark fits around what stands at the spot: a procedure in a chain. */
export function canMark(spot: Spot): boolean {
  return spot.kind === "chain" && spot.block.shape.kind === "method" && spot.block.shape.role === "instruction";
}

/** The innermost block around the spot (or at it) to which that shape adds a branch. */
export function branchOwner(spot: Spot, shape: Shape): Block | undefined {
  const adds = shape.constructor_?.adds;
  for (let at: Spot | null = spot; at !== null; at = at.owner) {
    if (adds?.constructor === at.block.shape.element) return at.block;
  }
  return undefined;
}

/** One more body in a repeated slot, at its end. */
export function growBranch(owner: Block, flow: string): void {
  const last = owner.bodies.findLastIndex((body) => body.out.startsWith(`${flow}.`));
  const count = owner.bodies.filter((body) => body.out.startsWith(`${flow}.`)).length;
  owner.bodies.splice(last + 1, 0, emptyBody(`${flow}.${String(count + 1)}`));
  renumber(owner, flow);
}

/** Takes one body of a repeated slot away; the later ones move up, notes at their ends with them. */
export function dropBranch(owner: Block, out: string): void {
  const flow = out.slice(0, out.lastIndexOf("."));
  owner.bodies = owner.bodies.filter((body) => body.out !== out);
  owner.vertex = { ...owner.vertex, notes: owner.vertex.notes.filter((note) => note.at !== `in:${out}`) };
  renumber(owner, flow);
}

function renumber(owner: Block, flow: string): void {
  const renamed = new Map<string, string>();
  let count = 0;
  for (const body of owner.bodies) {
    if (!body.out.startsWith(`${flow}.`)) continue;
    const out = `${flow}.${String(++count)}`;
    if (out === body.out) continue;
    renamed.set(`in:${body.out}`, `in:${out}`);
    body.out = out;
  }
  if (renamed.size === 0) return;
  const notes = owner.vertex.notes.map((note) => ({ ...note, at: renamed.get(note.at) ?? note.at }));
  owner.vertex = { ...owner.vertex, notes };
}

/** Blocks that can stand in a chain where they are dropped; a role that cannot is parked instead. */
export function park(structure: Structure, blocks: Block[]): void {
  if (blocks.length > 0) structure.parked.push(blocks);
}

/** The topmost of the given vertices, in reading order: what is inside another of them goes along with it. */
export function topmost(structure: Structure, ids: string[]): Spot[] {
  const wanted = new Set(ids);
  const inside = new Set<Block>();
  const spots: Spot[] = [];
  everySpot(structure, (spot) => {
    if (spot.owner !== null && inside.has(spot.owner.block)) inside.add(spot.block);
    else if (wanted.has(spot.block.vertex.id)) {
      inside.add(spot.block);
      spots.push(spot);
    }
  });
  return spots;
}

/** The mark block that stands around what the spot holds, or undefined. */
export function markAround(spot: Spot): Spot | undefined {
  return spot.kind === "slot" && isMark(spot.owner.block.shape) ? spot.owner : undefined;
}
