/**
 * The flowchart: one walk down a structure that gives every vertex, frame and arc its place.
 *
 * A chain is drawn down a middle line, the next vertex one PITCH below. What is still to be drawn of the arc that leaves
 * a vertex is its `Tail`: it ends where the next vertex, a bar or a loop takes it. A tail may hold several arcs that follow
 * each other (the end of a body, then the arc that leaves its owner) and may stand on a lane: a loop's exit has gone to
 * the right edge of the loop's frame and only comes back to the middle where somebody needs it there.
 *
 * Rules: a loop is its own frame, its left edge the return and its right edge the exit; a legend box has its
 * vertex on the top edge; branches run between two bars; the columns of a choice meet again; a Break's arc has a lane of its
 * own (break-edges.ts). The colour of an arc is that of its owner.
 */
import { t } from "../../i18n/words";
import { noteText } from "../notes";
import type { Block, Body, Structure } from "../structure";
import { text } from "../texts";
import { verticesOf } from "../tree";
import type { Colour, Vertex } from "../types";
import { LEAP_ROW, leapsOut } from "./break-edges";
import { Draft, type Piece, startPiece } from "./draft";
import { BODY_PLACE, ceilTo, GAP, HALF_BAR, HALF_ROW, LANE, type Measured, NOTE, PITCH, Sizes, TO_BAR } from "./sizes";
import type { ArcLabel, Layout, Point } from "./types";

interface Tail {
  pieces: Piece[];
  /** Whether the last point is on a lane beside the middle line. */
  lane: boolean;
}

interface Placed {
  tail: Tail;
  bottom: number;
  /** The y on which a lane comes back to the middle. */
  laneY: number;
  /** The middle of the vertex that follows. */
  next: number;
}

const EXIT_BELOW = 16;
const PLACE = { w: 320, h: 56, middle: 104, stop: 200 };
const PARKED_GAP = 64;

/** Vertex → the roles, groups and agents that act there. */
export type Acting = ReadonlyMap<string, readonly string[]>;

export class Placer {
  private readonly draft = new Draft();
  private readonly sizes: Sizes;

  private readonly acting: Acting;

  constructor(folded: ReadonlySet<string>, acting: Acting) {
    this.sizes = new Sizes(folded);
    this.acting = acting;
  }

  layout(structure: Structure): Layout {
    this.placeMain(structure);
    this.placeParked(structure);
    return this.draft.finished();
  }

  private placeMain({ start, stop, main, strays, parked }: Structure): void {
    if (start !== null) this.draft.terminal(start, "start", 0, "");
    const from = startPiece(start?.id ?? "", "next", "flow", { x: 0, y: HALF_ROW });
    const entry: Tail = { pieces: start === null ? [] : [from], lane: false };
    if (main.chain.length === 0 && main.closed && strays.length === 0 && parked.length === 0 && stop !== null) {
      this.placeEmpty(stop, from);
      return;
    }
    const placed = this.placeChain(main.chain, entry, 0, PITCH, HALF_ROW);
    const said = noteText(stop?.notes ?? []);
    const raised = said === "" ? 0 : NOTE;
    const end = placed.next + raised;
    if (stop !== null) this.draft.terminal(stop, "stop", end, said);
    if (stop !== null) this.draft.leaps.endBeside(0, this.draft.right() + GAP, { x: 60, y: end });
    this.draft.leaps.forget(0);
    this.end(placed, main.closed, [{ x: 0, y: end - HALF_ROW - raised }], 0);
  }

  /** A new program: a place to drop the first part on, in the middle of its only arc. */
  private placeEmpty(stop: Vertex, from: Piece): void {
    const { w, h, middle } = PLACE;
    this.draft.place("place", "action", { x: -w / 2, y: middle - h / 2, w, h });
    from.points.push({ x: 0, y: middle - h / 2 });
    this.draft.emit([from]);
    const below = startPiece(from.source, "next", "flow", { x: 0, y: middle + h / 2 });
    below.points.push({ x: 0, y: PLACE.stop - HALF_ROW });
    this.draft.emit([below]);
    this.draft.terminal(stop, "stop", PLACE.stop, "");
  }

  private placeParked({ parked }: Structure): void {
    this.draft.parked = true;
    let x = PARKED_GAP + this.draft.nodes.reduce((right, node) => Math.max(right, node.x + node.w), 0);
    x = this.draft.frames.reduce((right, frame) => Math.max(right, frame.x + frame.w + PARKED_GAP), x);
    let y = -HALF_ROW;
    for (const chain of parked) {
      const half = this.sizes.halfOf(chain);
      const frame = this.draft.frame("parked", chain[0]?.vertex.id ?? "", "team", x, y, 2 * half + 32);
      const middle = x + half + 16;
      const first = y + 40 + HALF_ROW;
      const placed = this.placeChain(chain, { pieces: [], lane: false }, middle, first, first);
      this.draft.leaps.forget(0);
      const goesOn = chain.at(-1)?.shape.role === "instruction";
      if (goesOn) this.end(placed, false, [], middle);
      frame.h = placed.bottom + (goesOn ? 40 : 16) - frame.y;
      y = frame.y + frame.h + 24;
    }
  }

  /** Places a chain from its first middle downwards; `bottom` is where what leads into it begins. */
  private placeChain(chain: Block[], entry: Tail, x: number, first: number, bottom: number): Placed {
    let placed: Placed = { tail: entry, bottom, laneY: bottom + EXIT_BELOW, next: first };
    for (const block of chain) {
      const measured = this.sizes.of(block);
      const raised = measured.note === "" ? 0 : NOTE;
      const middle = placed.next + raised;
      const top = (measured.style === "bars" ? middle - 16 - HALF_BAR : middle - HALF_ROW) - raised;
      this.take(placed, { x, y: top });
      placed = this.placeBlock(measured, x, middle);
    }
    return placed;
  }

  /** Draws a tail to its end at `point`, back from its lane if it is on one. */
  private take({ tail, laneY }: Placed, point: Point): void {
    const last = tail.pieces.at(-1);
    if (last === undefined) return;
    const at = last.points.at(-1);
    if (tail.lane && at !== undefined) last.points.push({ x: at.x, y: laneY }, { x: point.x, y: laneY });
    last.points.push(point);
    this.draft.emit(tail.pieces);
  }

  private placeBlock(measured: Measured, x: number, middle: number): Placed {
    switch (measured.style) {
      case "chip":
      case "simple":
        return this.placeSimple(measured, x, middle);
      case "legend":
        return this.placeLegend(measured, x, middle);
      case "loop":
        return this.placeLoop(measured, x, middle);
      case "bars":
        return this.placeBars(measured, x, middle);
      case "columns":
        return this.placeColumns(measured, x, middle);
    }
  }

  private placeSimple(measured: Measured, x: number, middle: number): Placed {
    const kind = measured.style === "chip" ? "chip" : measured.hexagon ? "hexagon" : "rect";
    this.draft.node(measured, kind, x, middle);
    const bottom = middle + HALF_ROW;
    const leaving = startPiece(arcId(measured), "next", "flow", { x, y: bottom });
    leaving.dead = leapsOut(measured.shown.shape);
    if (leaving.dead) this.draft.leaps.begin(measured, x, middle);
    return { tail: { pieces: [leaving], lane: false }, bottom, laneY: bottom, next: middle + PITCH };
  }

  private placeLegend(measured: Measured, x: number, middle: number): Placed {
    const { shown, half } = measured;
    const frame = this.draft.frame("legend", shown.vertex.id, shown.shape.colour, x - half, middle, 2 * half);
    this.draft.node(measured, measured.hexagon ? "hexagon" : "rect", x, middle);
    const [body] = shown.bodies;
    const inner = this.placeBody(measured, body, x, middle + PITCH, { x, y: middle + HALF_ROW }, 56 - HALF_ROW);
    const bottom = inner.bottom + 8;
    frame.h = bottom - middle;
    const { pieces, lane } = inner.tail;
    const last = pieces.at(-1);
    const at = last?.points.at(-1);
    const out = { x: lane && at !== undefined ? at.x : x, y: bottom };
    last?.points.push(out);
    const leaving = startPiece(arcId(measured), "next", "flow", out);
    return {
      tail: { pieces: [...pieces, leaving], lane },
      bottom,
      laneY: bottom + EXIT_BELOW,
      next: ceilTo(8, bottom + (lane ? 56 : PITCH - HALF_ROW)),
    };
  }

  private placeLoop(measured: Measured, x: number, middle: number): Placed {
    const { shown, half, width } = measured;
    const { colour } = shown.shape;
    const frame = this.draft.frame("loop", shown.vertex.id, colour, x - half, middle, 2 * half);
    this.draft.node(measured, measured.hexagon ? "hexagon" : "rect", x, middle);
    const [body] = shown.bodies;
    const label: ArcLabel = { text: bodyLabel(shown, body), x: x + 8, y: middle + HALF_ROW + 10, anchor: "start" };
    const leaps = this.draft.leaps.mark();
    const inner = this.placeBody(
      measured,
      body,
      x,
      middle + PITCH,
      { x, y: middle + HALF_ROW },
      PITCH - HALF_ROW,
      label,
    );
    const bottom = ceilTo(8, inner.bottom + (inner.tail.lane ? EXIT_BELOW : 8));
    frame.h = bottom - middle;
    const { plugs, fields } = shown.shape;
    // A loop that nothing ends, neither a test or a number nor a part inside, is never done.
    const ends = plugs.length + fields.length > 0 || this.draft.leaps.isOpen(leaps);
    this.draft.leaps.endAt(leaps, x + half);
    const left = x - half;
    this.close(
      inner.tail,
      x,
      bottom,
      [
        { x: left, y: bottom },
        { x: left, y: middle },
        { x: x - width / 2, y: middle },
      ],
      colour,
    );
    const leaving = startPiece(arcId(measured), "next", colour, { x: x + width / 2, y: middle });
    leaving.fixed = true;
    leaving.points.push({ x: x + half, y: middle });
    if (ends) leaving.label = { text: t("graph.done"), x: x + width / 2 + 8, y: middle - 11, anchor: "start" };
    return { tail: { pieces: [leaving], lane: true }, bottom, laneY: bottom + EXIT_BELOW, next: bottom + 56 };
  }

  private placeBars(measured: Measured, x: number, middle: number): Placed {
    const { shown, half, columns } = measured;
    const { colour } = shown.shape;
    const bar = middle - 16;
    const frame = this.draft.frame("parallel", shown.vertex.id, colour, x - half, bar, 2 * half);
    this.draft.bar(measured, "bar", x, bar);
    const { leaps } = this.draft;
    const marks: number[] = [];
    const lanes = shown.bodies.map(({ chain }) => this.namesIn(chain));
    const top = bar + (lanes.some((names) => names.length > 0) ? LANE : 0);
    const inner = shown.bodies.map((body, index) => {
      const at = x + (columns[index] ?? 0);
      marks.push(leaps.mark());
      return this.placeBody(measured, body, at, top + TO_BAR, { x: at, y: top + HALF_BAR }, 52);
    });
    const deepest = inner.reduce((most, placed) => Math.max(most, placed.bottom), top + 40);
    const end = ceilTo(8, deepest + 24);
    frame.h = end - bar;
    inner.forEach(({ tail }, index) => {
      this.close(tail, x + (columns[index] ?? 0), end - HALF_BAR, [], colour);
    });
    let left = x - half;
    if (top > bar)
      lanes.forEach((names, index) => {
        const right = index === lanes.length - 1 ? x + half : this.gap(measured, index, x);
        const id = `${shown.vertex.id}.${shown.bodies[index]?.out ?? ""}`;
        this.draft.lanes.push({
          id,
          first: index === 0,
          names,
          x: left,
          y: bar + HALF_BAR,
          w: right - left,
          h: end - bar - 2 * HALF_BAR,
        });
        left = right;
      });
    for (let index = marks.length - 1; index >= 0; index--) {
      leaps.endBelow(marks[index] ?? 0, Math.min(this.gap(measured, index, x), x + half - 8), end - HALF_BAR);
    }
    this.draft.bar(measured, "barEnd", x, end);
    const leaving = startPiece(arcId(measured), "next", colour, { x, y: end + HALF_BAR });
    const bottom = end + HALF_BAR;
    return { tail: { pieces: [leaving], lane: false }, bottom, laneY: bottom, next: end + TO_BAR };
  }

  private placeColumns(measured: Measured, x: number, middle: number): Placed {
    const { shown, half, width, columns } = measured;
    const { colour } = shown.shape;
    const frame = this.draft.frame("legend", shown.vertex.id, colour, x - half, middle, 2 * half);
    this.draft.node(measured, "hexagon", x, middle);
    const { leaps } = this.draft;
    const marks: number[] = [];
    const inner = shown.bodies.map((body, index) => {
      marks.push(leaps.mark());
      const at = x + (columns[index] ?? 0);
      const side = Math.sign(index - (shown.bodies.length - 1) / 2);
      const label: ArcLabel = {
        text: bodyLabel(shown, body),
        x: side === 0 ? x + 8 : x + side * (width / 2 + 8),
        y: side === 0 ? middle + HALF_ROW + 10 : middle - 11,
        anchor: side < 0 ? "end" : "start",
      };
      const from = side === 0 ? { x, y: middle + HALF_ROW } : { x: x + (side * width) / 2, y: middle };
      return this.placeBody(measured, body, at, middle + PITCH, from, side === 0 ? 42 : PITCH, label);
    });
    const deepest = inner.reduce((most, placed) => Math.max(most, placed.bottom), middle);
    const last = marks.at(-1) ?? 0;
    const row = last > (marks[0] ?? 0) ? LEAP_ROW : 0;
    marks.slice(0, -1).forEach((mark, index) => {
      leaps.turn(mark, marks[index + 1] ?? last, this.gap(measured, index, x), deepest + LEAP_ROW);
    });
    const meet = ceilTo(8, deepest + row + EXIT_BELOW);
    inner.forEach(({ tail }, index) => {
      const column = x + (columns[index] ?? 0);
      this.close(tail, column, meet, column === x && !tail.lane ? [] : [{ x, y: meet }], colour, false);
    });
    const bottom = meet + 8;
    frame.h = bottom - middle;
    const leaving = startPiece(arcId(measured), "next", "flow", { x, y: meet });
    const next = ceilTo(8, bottom + PITCH - HALF_ROW);
    return { tail: { pieces: [leaving], lane: false }, bottom, laneY: bottom, next };
  }

  /** Who acts in a chain, each once. */
  private namesIn(chain: Block[]): string[] {
    if (this.acting.size === 0) return [];
    return [...new Set(chain.flatMap(verticesOf).flatMap(({ id }) => this.acting.get(id) ?? []))];
  }

  /** The middle of the gap on the right of a column. */
  private gap({ shown, columns }: Measured, index: number, x: number): number {
    return x + (columns[index] ?? 0) + this.sizes.halfOf(shown.bodies[index]?.chain ?? []) + GAP / 2;
  }

  /** Places the chain of a body below `from`; an empty one is an arc that goes `empty` further down. */
  private placeBody(
    owner: Measured,
    body: Body | undefined,
    x: number,
    first: number,
    from: Point,
    empty: number,
    label: ArcLabel | null = null,
  ): Placed {
    const { shape, vertex } = owner.shown;
    const leaving = startPiece(vertex.id, body?.out ?? "", shape.colour, from);
    leaving.label = label;
    if (from.x !== x) this.bend(leaving, from, x, owner, first);
    const chain = body?.chain ?? [];
    if (body !== undefined && isOpenPlace(owner, body)) {
      const { w, h } = BODY_PLACE;
      const [top, bottom] = [first - h / 2, first + h / 2];
      this.draft.place(`${vertex.id}.${body.out}`, shape.colour, { x: x - w / 2, y: top, w, h });
      leaving.points.push({ x, y: top });
      this.draft.emit([leaving]);
      const below = startPiece(vertex.id, body.out, shape.colour, { x, y: bottom });
      return { tail: { pieces: [below], lane: false }, bottom, laneY: bottom + EXIT_BELOW, next: first + PITCH };
    }
    const bottom = chain.length === 0 ? from.y + empty : from.y;
    const placed = this.placeChain(chain, { pieces: [leaving], lane: false }, x, first, bottom);
    if (body?.closed !== false) return placed;
    this.end(placed, false, [], x);
    return { ...placed, tail: { pieces: [], lane: false }, bottom: placed.bottom + EXIT_BELOW };
  }

  /** From the side of a vertex straight over its column; from its bottom by way of a step. */
  private bend(leaving: Piece, from: Point, x: number, owner: Measured, first: number): void {
    const sideways = from.y === first - PITCH;
    const y = sideways || owner.style !== "columns" ? from.y : from.y + 10;
    if (y !== from.y) leaving.points.push({ x: from.x, y });
    leaving.points.push({ x, y });
  }

  /** Ends a body: down to `y`, then along `after`, all of it in its owner's colour. */
  private close(tail: Tail, x: number, y: number, after: Point[], colour: Colour, head = true): void {
    const last = tail.pieces.at(-1);
    const at = last?.points.at(-1);
    if (last === undefined || at === undefined) return;
    last.points.push({ x: tail.lane ? at.x : x, y }, ...after);
    for (const piece of tail.pieces) if (!piece.fixed) piece.colour = colour;
    this.draft.emit(tail.pieces, head);
  }

  /** Ends a chain that has no owner to return to: at `points`, or as a stub where an arc is missing. */
  private end(placed: Placed, closed: boolean, points: Point[], x: number): void {
    const [point] = points;
    if (closed && point !== undefined) {
      this.take(placed, point);
      return;
    }
    const last = placed.tail.pieces.at(-1);
    const at = last?.points.at(-1);
    if (last === undefined || at === undefined) return;
    last.points.push({ x: placed.tail.lane ? at.x : x, y: placed.bottom + EXIT_BELOW });
    this.draft.emit(placed.tail.pieces, false, true);
  }
}

/** Whether an empty body has a place to drop on: where it is the only one. */
function isOpenPlace({ style }: Measured, body: Body): boolean {
  return (style === "loop" || style === "legend") && body.chain.length === 0 && body.closed;
}

/** The vertex by which arcs leave: the mark around an action, else the vertex itself. */
function arcId({ shown, mark }: Measured): string {
  return (mark ?? shown).vertex.id;
}

function bodyLabel({ shape }: Block, body: Body | undefined): string {
  const flow = shape.flows.find((one) => one.name === body?.out);
  return flow === undefined ? (body?.out ?? "") : text(flow.label, flow.name);
}
