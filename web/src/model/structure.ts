/**
 * A program's structure, read off its arcs in one linear walk.
 *
 * A program is a chain from Start to Stop; a chain is a sequence of blocks; a block is a vertex with its bodies (one chain
 * a flow port, from the port to the vertex's own `return`) and its plugs (the vertex that fills a condition, value or
 * action slot). Chains that hang on nothing are parked. Arcs that fit nowhere (an arc into the middle of another body, two
 * out of one port, …) are strays: kept word for word and written back at the end, so that no edit ever loses them; the
 * server says what is wrong with them. A body whose last arc is missing is not `closed`.
 *
 * `readStructure` gives a fresh tree that its caller may change; `writeStructure` makes a program of it, in reading order.
 * Invariant: write(read(p)) has the vertices and arcs of p, and read(write(s)) equals s.
 */
import type { Parts, Shape } from "./parts";
import type { Arc, Program, Vertex } from "./types";

/** As deep as the server's programs nest, with room: what is deeper becomes strays and parked chains. */
const MAX_DEPTH = 400;

export interface Block {
  vertex: Vertex;
  shape: Shape;
  bodies: Body[];
  plugs: Plugged[];
}

export interface Body {
  /** The out-port that the chain hangs on. */
  out: string;
  chain: Block[];
  /** Whether the last arc arrives where it must. */
  closed: boolean;
}

export interface Plugged {
  slot: string;
  block: Block | null;
}

export interface Structure {
  /** Whose structure it is: all of the program that is not its graph. */
  of: Omit<Program, "vertices" | "arcs">;
  start: Vertex | null;
  stop: Vertex | null;
  /** From Start's `next`. */
  main: Body;
  parked: Block[][];
  strays: Arc[];
  /** The arcs as they were read, by source and port: one that is there again is the same object. */
  drawn: ReadonlyMap<string, ReadonlyMap<string, readonly Arc[]>>;
  /** Vertices with an id that another one has already. */
  lost: Vertex[];
}

class Reader {
  private readonly vertices = new Map<string, Vertex>();
  private readonly leaving = new Map<string, Map<string, Arc[]>>();
  private readonly entering = new Map<string, Arc[]>();
  private readonly seen = new Set<string>();
  private readonly used = new Set<Arc>();
  private readonly lost: Vertex[] = [];

  private readonly program: Program;
  private readonly parts: Parts;

  constructor(program: Program, parts: Parts) {
    this.program = program;
    this.parts = parts;
    for (const vertex of program.vertices) {
      if (this.vertices.has(vertex.id)) this.lost.push(vertex);
      else this.vertices.set(vertex.id, vertex);
    }
    for (const arc of program.arcs) {
      let ports = this.leaving.get(arc.source);
      if (ports === undefined) this.leaving.set(arc.source, (ports = new Map<string, Arc[]>()));
      const same = ports.get(arc.out);
      if (same === undefined) ports.set(arc.out, [arc]);
      else same.push(arc);
      const into = this.entering.get(arc.target);
      if (into === undefined) this.entering.set(arc.target, [arc]);
      else into.push(arc);
    }
  }

  read(): Structure {
    const { program } = this;
    const start = program.vertices.find((vertex) => vertex.element === "Start") ?? null;
    const stop = program.vertices.find((vertex) => vertex.element === "Stop") ?? null;
    if (start !== null) this.seen.add(start.id);
    if (stop !== null) this.seen.add(stop.id);
    const main: Body =
      start === null ? { out: "next", chain: [], closed: false } : this.body(start.id, "next", stop?.id ?? "", "in", 0);
    const parked = this.parked();
    const strays = program.arcs.filter((arc) => !this.used.has(arc));
    const { vertices: _vertices, arcs: _arcs, ...of } = program;
    return { of, start, stop, main, parked, strays, drawn: this.leaving, lost: this.lost };
  }

  private body(owner: string, out: string, closer: string, at: string, depth: number): Body {
    const chain: Block[] = [];
    const closed = this.follow(owner, out, chain, closer, at, depth);
    return { out, chain, closed };
  }

  /** Walks from a port along `next` until the closing port; says whether it got there. */
  private follow(source: string, out: string, chain: Block[], closer: string, at: string, depth: number): boolean {
    for (;;) {
      const arc = this.leaving
        .get(source)
        ?.get(out)
        ?.find((one) => this.leads(one, closer, at, depth));
      if (arc === undefined) return false;
      this.used.add(arc);
      if (arc.target === closer && arc.at === at) return true;
      const vertex = this.vertices.get(arc.target);
      if (vertex === undefined) return false;
      chain.push(this.block(vertex, depth));
      source = vertex.id;
      out = "next";
    }
  }

  private leads(arc: Arc, closer: string, at: string, depth: number): boolean {
    if (arc.target === closer && arc.at === at) return true;
    return arc.at === "in" && depth < MAX_DEPTH && this.vertices.has(arc.target) && !this.seen.has(arc.target);
  }

  private block(vertex: Vertex, depth: number): Block {
    this.seen.add(vertex.id);
    const shape = this.parts.shape(vertex.element);
    const plugs = this.plugNames(vertex, shape).map((slot) => ({ slot, block: this.plugged(vertex, slot, depth + 1) }));
    const bodies = this.ports(vertex, shape).map((out) => this.body(vertex.id, out, vertex.id, "return", depth + 1));
    return { vertex, shape, bodies, plugs };
  }

  private plugNames(vertex: Vertex, shape: Shape): string[] {
    if (shape.kind !== "unknown") return shape.plugs.map((plug) => plug.name);
    const arcs = this.entering.get(vertex.id) ?? [];
    return [...new Set(arcs.map((arc) => arc.at))].filter((at) => at !== "in" && at !== "return");
  }

  private plugged(vertex: Vertex, slot: string, depth: number): Block | null {
    for (const arc of this.entering.get(vertex.id) ?? []) {
      if (arc.at !== slot || arc.out !== "next" || this.seen.has(arc.source) || depth >= MAX_DEPTH) continue;
      const filler = this.vertices.get(arc.source);
      if (filler === undefined) continue;
      this.used.add(arc);
      return this.block(filler, depth);
    }
    return null;
  }

  /** The out-ports of a vertex's bodies, in order. */
  private ports(vertex: Vertex, shape: Shape): string[] {
    const drawn = [...(this.leaving.get(vertex.id)?.keys() ?? [])];
    if (shape.kind === "unknown") return drawn.filter((out) => out !== "next");
    return shape.flows.flatMap((flow) => {
      if (!flow.repeat) return [flow.name];
      const counted = drawn.filter((out) => branchNumber(out, flow.name) > 0);
      return counted.sort((a, b) => branchNumber(a, flow.name) - branchNumber(b, flow.name));
    });
  }

  /** Chains that hang on nothing, in the order of the file; what is left of a ring begins at its first vertex. */
  private parked(): Block[][] {
    const chains: Block[][] = [];
    const isFree = (id: string) => this.vertices.has(id) && !this.seen.has(id);
    const isHead = (vertex: Vertex) =>
      !(this.entering.get(vertex.id) ?? []).some((arc) => arc.at === "in" && isFree(arc.source)) &&
      !(this.leaving.get(vertex.id)?.get("next") ?? []).some((arc) => arc.at !== "in" && isFree(arc.target));
    const rest = [...this.vertices.values()].filter((vertex) => !this.seen.has(vertex.id));
    for (const vertex of [...rest.filter(isHead), ...rest]) {
      if (this.seen.has(vertex.id)) continue;
      const chain = [this.block(vertex, 0)];
      if (this.parts.shape(vertex.element).role === "instruction") this.follow(vertex.id, "next", chain, "", "", 0);
      chains.push(chain);
    }
    return chains;
  }
}

function branchNumber(out: string, flow: string): number {
  const tail = out.startsWith(`${flow}.`) ? out.slice(flow.length + 1) : "";
  return /^[1-9][0-9]{0,5}$/.test(tail) ? Number(tail) : 0;
}

/** A fresh tree of the program; the caller may change it. */
export function readStructure(program: Program, parts: Parts): Structure {
  return new Reader(program, parts).read();
}

/** The program of a structure, its vertices and arcs in reading order, strays last. */
export function writeStructure(structure: Structure): Program {
  const vertices: Vertex[] = [];
  const arcs: Arc[] = [];

  const join = (source: string, out: string, target: string, at: string) => {
    const same = structure.drawn
      .get(source)
      ?.get(out)
      ?.find((one) => one.target === target && one.at === at);
    arcs.push(same ?? { source, target, out, at });
  };

  const block = (one: Block) => {
    vertices.push(one.vertex);
    for (const { slot, block: filler } of one.plugs) {
      if (filler === null) continue;
      block(filler);
      join(filler.vertex.id, "next", one.vertex.id, slot);
    }
    for (const body of one.bodies) chain(one.vertex.id, body, one.vertex.id, "return");
  };

  const chain = (owner: string, body: Body, closer: string, at: string) => {
    let source = owner;
    let out = body.out;
    for (const one of body.chain) {
      join(source, out, one.vertex.id, "in");
      block(one);
      source = one.vertex.id;
      out = "next";
    }
    if (body.closed) join(source, out, closer, at);
  };

  const { start, stop, main, parked, strays, lost, of } = structure;
  if (start !== null) {
    vertices.push(start);
    chain(start.id, main, stop?.id ?? "", "in");
  }
  if (stop !== null) vertices.push(stop);
  for (const [first, ...rest] of parked) {
    if (first === undefined) continue;
    block(first);
    chain(first.vertex.id, { out: "next", chain: rest, closed: false }, "", "");
  }
  return { ...of, vertices: [...vertices, ...lost], arcs: [...arcs, ...strays] };
}
