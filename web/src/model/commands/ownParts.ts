/**
 * Parts of one's own where they are used: a selection becomes one, a changed part changes its vertices, and a part's
 * instructions take the place of its vertices.
 */
import { t } from "../../i18n/words";
import { type Command, commandTo } from "../command";
import { blocksOf } from "../fragment";
import { catalogueOf, ownConstructors, ownVariables } from "../own-parts";
import { fits, type Parts, partsOf, type Shape } from "../parts";
import { type Block, type Body, readStructure, type Structure, writeStructure } from "../structure";
import { copyBlock, everySpot, freshIds, newBlock, type Spot } from "../tree";
import type { Catalogue, Constructor, Mission, Note, Program, Vertex } from "../types";
import { addConstructor, changeConstructor, usesOfConstructor, withOwn } from "./changeOwn";

/** The part at the end of the mission's, and the program that has a vertex of it, or null to leave the program. */
export function saveAsPart(
  mission: Mission,
  made: Constructor,
  inPlace: { program: Program; vertex: string } | null,
): Command | null {
  const added = addConstructor(mission, made);
  if (added === null || inPlace === null) return added;
  const { program, vertex } = inPlace;
  const after = added.execute(mission);
  const programs = after.programs.map((one) => (one.name === program.name ? program : one));
  return commandTo(t("own.command-save", { name: made.name }), { ...after, programs }, { selects: [vertex] });
}

/** Whether vertices of the one part are vertices of the other as they are. */
function sameSlots(before: Constructor, after: Constructor): boolean {
  const key = ({ slots }: Constructor) => slots.map(({ name, kind, repeat }) => `${kind} ${name} ${String(repeat)}`);
  return key(before).sort().join("\n") === key(after).sort().join("\n");
}

/**
 * The command that puts another part in the place of one; null when its name is taken. What its vertices hold stays in
 * slots of the same name; new slots have their defaults, and what stood in a slot that is gone is parked.
 */
export function changePart(mission: Mission, files: Catalogue, name: string, made: Constructor): Command | null {
  const changed = changeConstructor(mission, name, made);
  const before = ownConstructors(mission).find((one) => one.name === name);
  if (changed === null || before === undefined || sameSlots(before, made)) return changed;
  const after = changed.execute(mission);
  const [was, is] = [catalogueOf(files, mission), catalogueOf(files, after)];
  const programs = mission.programs.map((program) => {
    if (program.vertices.every((vertex) => vertex.element !== name)) return program;
    const shape = partsOf(is, program.robot).shape(made.name);
    const structure = readStructure(program, partsOf(was, program.robot));
    const spots: Spot[] = [];
    everySpot(structure, (spot) => {
      if (spot.block.shape.element === name) spots.push(spot);
    });
    for (const { block } of spots) structure.parked.push(...reshape(block, shape));
    return writeStructure(structure);
  });
  return { ...changed, execute: () => ({ ...after, programs }) };
}

/** Makes a block one of another shape, in place; the chains that have no slot any more. */
function reshape(block: Block, shape: Shape): Block[][] {
  const fresh = newBlock(shape, block.vertex.id);
  const left: Block[][] = [];
  for (const { slot, block: filler } of block.plugs) {
    const plug = fresh.plugs.find((one) => one.slot === slot);
    const wanted = shape.plugs.find((one) => one.name === slot);
    if (filler === null) continue;
    if (plug !== undefined && wanted !== undefined && fits(filler.shape, wanted)) plug.block = filler;
    else left.push([filler]);
  }
  const kept = new Set<Body>();
  const bodies = shape.flows.flatMap((flow) => {
    const same = block.bodies.filter(({ out }) => (flow.repeat ? isBranch(out, flow.name) : out === flow.name));
    for (const body of same) kept.add(body);
    return same.length > 0 ? same : fresh.bodies.filter(({ out }) => out === flow.name || isBranch(out, flow.name));
  });
  for (const body of block.bodies) if (!kept.has(body) && body.chain.length > 0) left.push(body.chain);
  const plugged = new Set(fresh.plugs.flatMap((one) => (one.block === null ? [] : [one.slot])));
  const settings = Object.fromEntries(
    Object.entries(fresh.vertex.settings)
      .filter(([name]) => !plugged.has(name))
      .map(([name, value]) => [name, block.vertex.settings[name] ?? value]),
  );
  const ports = new Set(bodies.map(({ out }) => `in:${out}`));
  const notes = block.vertex.notes.map((note) =>
    note.at.startsWith("in:") && !ports.has(note.at) ? { ...note, at: "" } : note,
  );
  block.vertex = { ...block.vertex, element: shape.element, settings, notes };
  Object.assign(block, { shape, plugs: fresh.plugs, bodies });
  return left;
}

function isBranch(out: string, flow: string): boolean {
  return out.startsWith(`${flow}.`) && /^[0-9]+$/.test(out.slice(flow.length + 1));
}

/** A part's template as a graph for each robot: what stands for a slot is named `{slot}`. */
export type Drawings = ReadonlyMap<string, Program>;

/**
 * The command that puts a part's instructions where it is used, with what each vertex was given, and takes the part away;
 * null when there is no such part, or no drawing of it for a robot that uses it.
 */
export function dissolvePart(mission: Mission, files: Catalogue, name: string, drawings: Drawings): Command | null {
  const own = ownConstructors(mission);
  if (!own.some((one) => one.name === name)) return null;
  const users = new Set(usesOfConstructor(mission, name).map(({ program }) => program));
  const catalogue = catalogueOf(files, mission);
  if (mission.programs.some((program) => users.has(program.name) && !drawings.has(program.robot))) return null;
  const programs = mission.programs.map((program) => {
    const drawing = users.has(program.name) ? drawings.get(program.robot) : undefined;
    return drawing === undefined ? program : dissolved(program, partsOf(catalogue, program.robot), name, drawing);
  });
  const rest = own.filter((one) => one.name !== name);
  const after = { ...withOwn(mission, rest, ownVariables(mission)), programs };
  return commandTo(t("own.command-dissolve", { name }), after);
}

function dissolved(program: Program, parts: Parts, name: string, drawing: Program): Program {
  const structure = readStructure(program, parts);
  const spots: Spot[] = [];
  everySpot(structure, (spot) => {
    if (spot.block.shape.element === name) spots.push(spot);
  });
  const nextId = freshIds(structure);
  // What stands inside others first: it moves along with what holds it.
  for (const spot of spots.reverse()) replaceSpot(structure, spot, new Filling(spot.block, nextId).all(drawing, parts));
  return writeStructure(structure);
}

function replaceSpot(structure: Structure, spot: Spot, blocks: Block[]): void {
  if (spot.kind === "chain") {
    spot.chain.splice(spot.chain.indexOf(spot.block), 1, ...blocks);
    structure.parked = structure.parked.filter((chain) => chain.length > 0);
    return;
  }
  for (const plug of spot.owner.block.plugs) if (plug.block === spot.block) plug.block = blocks[0] ?? null;
}

/** The hole that an element or a setting of a drawing stands for, or null. */
function holeOf(text: string): string | null {
  return /^\{(.*)\}$/.exec(text)?.[1] ?? null;
}

/** A template's blocks with the slots of one vertex in its holes. */
class Filling {
  private readonly use: Block;
  private readonly nextId: () => string;

  constructor(use: Block, nextId: () => string) {
    this.use = use;
    this.nextId = nextId;
  }

  all(drawing: Program, parts: Parts): Block[] {
    const copies = blocksOf(drawing, parts).map((block) => copyBlock(block, this.nextId));
    const blocks = this.chain(copies);
    this.keepNotes(blocks);
    return blocks;
  }

  private chain(blocks: Block[]): Block[] {
    return blocks.flatMap((block) => {
      const hole = holeOf(block.shape.element);
      if (hole === null) return [this.filled(block)];
      return this.use.bodies.find(({ out }) => out === hole)?.chain ?? [];
    });
  }

  private filled(block: Block): Block {
    const settings: Record<string, string> = {};
    for (const [name, text] of Object.entries(block.vertex.settings)) {
      const hole = holeOf(text);
      const plugged = hole === null ? null : this.plug(hole);
      const own = block.plugs.find(({ slot }) => slot === name);
      if (plugged !== null && own !== undefined) own.block = plugged;
      else settings[name] = hole === null ? text : this.setting(hole);
    }
    block.vertex = { ...block.vertex, settings };
    for (const one of block.plugs) {
      const hole = one.block === null ? null : holeOf(one.block.shape.element);
      if (hole !== null) one.block = this.plug(hole);
      else if (one.block !== null && !this.use.plugs.some(({ block: filler }) => filler === one.block))
        one.block = this.filled(one.block);
    }
    block.bodies = block.bodies.flatMap((body) => this.body(block, body));
    return block;
  }

  private body(block: Block, body: Body): Body[] {
    const [first] = body.chain;
    const hole = first === undefined ? null : holeOf(first.shape.element);
    const branches = hole === null ? [] : this.use.bodies.filter(({ out }) => isBranch(out, hole));
    if (hole === null || branches.length === 0) {
      if (hole !== null) this.moveNotes(block, hole, body.out);
      return [{ ...body, chain: this.chain(body.chain) }];
    }
    const base = body.out.slice(0, body.out.lastIndexOf(".") + 1);
    return branches.map((branch, at) => {
      const out = `${base}${String(at + 1)}`;
      this.moveNotes(block, branch.out, out);
      return { ...branch, out };
    });
  }

  /** Notes at the end of a body go with it. */
  private moveNotes(block: Block, from: string, to: string): void {
    const moved = this.notes(`in:${from}`).map((note) => ({ ...note, at: `in:${to}` }));
    this.moved.push(`in:${from}`);
    block.vertex = { ...block.vertex, notes: [...block.vertex.notes, ...moved] };
  }

  private readonly moved: string[] = ["", "after"];

  private notes(at: string): Note[] {
    return this.use.vertex.notes.filter((note) => note.at === at);
  }

  /** Notes of the vertex stay with the first and the last of what takes its place. */
  private keepNotes(blocks: Block[]): void {
    const [first, last] = [blocks[0], blocks.at(-1)];
    if (first === undefined || last === undefined) return;
    const others = this.use.vertex.notes.filter((note) => !this.moved.includes(note.at));
    const above = [...this.notes(""), ...others.map((note) => ({ ...note, at: "" }))];
    first.vertex = withNotes(first.vertex, [...above, ...first.vertex.notes]);
    last.vertex = withNotes(last.vertex, [...last.vertex.notes, ...this.notes("after")]);
  }

  private plug(slot: string): Block | null {
    return this.use.plugs.find((one) => one.slot === slot)?.block ?? null;
  }

  private setting(slot: string): string {
    return this.use.vertex.settings[slot] ?? this.use.shape.fields.find((one) => one.name === slot)?.default ?? "0";
  }
}

function withNotes(vertex: Vertex, notes: Note[]): Vertex {
  return notes.length === vertex.notes.length ? vertex : { ...vertex, notes };
}
