/**
 * Widths: of each vertex, and of each block with all it holds. Everything is symmetric about its middle line, so one
 * number a block, its half width, is enough; halves are multiples of 8, which keeps middles on the grid.
 */
import { languageInUse, t } from "../../i18n/words";
import { textWidth } from "../measure";
import { noteText } from "../notes";
import { isMark, type Shape } from "../parts";
import type { Block } from "../structure";
import { verticesOf } from "../tree";
import type { Vertex } from "../types";
import { chipOf, chipWidth, type Face, faceOf, faceWidth } from "../vertex-content";
import { leapsOut } from "./break-edges";
import type { Inside } from "./types";

export type Style = "simple" | "legend" | "loop" | "bars" | "columns" | "chip";

/** Half the height of a vertex. */
export const HALF_ROW = 22;
/** From the middle of a vertex to the middle of the next one. */
export const PITCH = 64;
/** From the middle of a vertex to a bar. */
export const TO_BAR = 48;
export const HALF_BAR = 4;
/** The height of a note above a vertex. */
export const NOTE = 24;
/** The height of the head of a lane. */
export const LANE = 36;
export const GAP = 24;
/** Where something is to be dropped in an empty body. */
export const BODY_PLACE = { w: 304, h: 48 };
export const LOOP_SIDE = 24;
export const LEGEND_SIDE = 16;
const LEAP_SIDE = 40;

export interface Measured {
  style: Style;
  /** What is drawn: the action inside a mark, else the block itself. */
  shown: Block;
  mark: Block | null;
  face: Face;
  /** What is hidden in it, or null when it is not folded. */
  inside: Inside | null;
  /** What is written above it. */
  note: string;
  /** Whether the vertex itself is a stretched diamond. */
  hexagon: boolean;
  /** Width of the vertex itself. */
  width: number;
  /** Half the width with all it holds. */
  half: number;
  /** Middles of the bodies' columns, from the block's middle. */
  columns: number[];
}

export function ceilTo(grid: number, value: number): number {
  return Math.ceil(value / grid) * grid;
}

function styleOf({ shape, bodies }: Block): Style {
  if (shape.role === "condition" || shape.role === "value") return "chip";
  if (bodies.length === 0 && !shape.flows.some((flow) => flow.repeat)) return "simple";
  if (shape.flows.some((flow) => flow.repeat)) return "bars";
  if (bodies.length > 1) return "columns";
  return shape.flows[0]?.loop === true ? "loop" : "legend";
}

export class Sizes {
  private readonly table = new Map<Block, Measured>();
  private readonly folded: ReadonlySet<string>;

  constructor(folded: ReadonlySet<string>) {
    this.folded = folded;
  }

  of(block: Block): Measured {
    let measured = this.table.get(block);
    if (measured === undefined) this.table.set(block, (measured = this.measure(block)));
    return measured;
  }

  /** Half the width of a chain; an empty one still has room for an arc to drop on. */
  halfOf(chain: Block[]): number {
    return chain.reduce((widest, block) => Math.max(widest, this.of(block).half), 48);
  }

  private measure(block: Block): Measured {
    const held = isMark(block.shape) ? block.plugs[0]?.block : null;
    const shown = held ?? block;
    const inside = shown.bodies.length > 0 && this.folded.has(shown.vertex.id) ? insideOf(shown) : null;
    const open = styleOf(shown);
    const style = inside === null ? open : "simple";
    const drawn = seenOf(shown);
    const { face } = drawn;
    const hexagon = open === "columns" || (open !== "loop" && open !== "bars" && isChoice(shown));
    const looks = `${style} ${String(hexagon)}`;
    let width = drawn.widths.get(looks);
    if (width === undefined) drawn.widths.set(looks, (width = vertexWidth(shown, style, face, hexagon)));
    width += inside === null ? 0 : foldedWidth(inside);
    const measured = {
      style,
      shown,
      mark: held == null ? null : block,
      face,
      hexagon,
      width,
      inside,
      note: noteOf(block, shown),
    };
    const halves = inside !== null ? [] : shown.bodies.map((body) => this.halfOf(body.chain));
    const isEmpty = (style === "loop" || style === "legend") && shown.bodies[0]?.chain.length === 0;
    const size = extent(style, width, isEmpty ? [BODY_PLACE.w / 2] : halves);
    // The word at the lane of a Break stands beside it.
    if (leapsOut(shown.shape)) size.half = ceilTo(8, width / 2 + LEAP_SIDE);
    return { ...measured, ...size };
  }
}

type Seeing = Shape | Vertex | string;

interface Seen {
  language: string;
  /** What it was made of: the vertex, its shape, and each slot with what fills it. */
  of: readonly Seeing[];
  face: Face;
  widths: Map<string, number>;
}

/** What vertices show: an edit leaves nearly all of them as they are. */
const seen = new WeakMap<Vertex, Seen>();

function madeOf(block: Block, into: Seeing[] = []): Seeing[] {
  into.push(block.vertex, block.shape);
  for (const plug of block.plugs) {
    into.push(plug.slot);
    if (plug.block !== null) madeOf(plug.block, into);
  }
  return into;
}

function seenOf(block: Block): Seen {
  const of = madeOf(block);
  const language = languageInUse();
  const known = seen.get(block.vertex);
  if (known?.language === language && known.of.length === of.length && known.of.every((one, at) => one === of[at]))
    return known;
  const made = { language, of, face: faceOf(block), widths: new Map<string, number>() };
  seen.set(block.vertex, made);
  return made;
}

/** The notes above a vertex, those of its mark included. */
function noteOf(block: Block, shown: Block): string {
  const both = block === shown ? [shown] : [block, shown];
  return both
    .map(({ vertex }) => noteText(vertex.notes))
    .filter((note) => note !== "")
    .join("\n");
}

function insideOf(block: Block): Inside {
  const held = block.bodies.flatMap((body) => body.chain);
  return {
    count: held.reduce((sum, one) => sum + 1 + insideOf(one).count, 0),
    vertices: held.flatMap((one) => verticesOf(one).map((vertex) => vertex.id)),
  };
}

/** Room for the words on a folded vertex. */
function foldedWidth({ count }: Inside): number {
  return ceilTo(16, textWidth(t("graph.folded", { count }), 14, true) + 24);
}

/** A condition that is looked at without a loop makes a diamond. */
function isChoice({ shape }: Block): boolean {
  return shape.kind === "constructor" && shape.plugs.some((plug) => plug.accepts === "condition");
}

function vertexWidth(block: Block, style: Style, face: Face, hexagon: boolean): number {
  if (style === "chip") return ceilTo(8, chipWidth(chipOf(block)));
  if (style === "bars") return ceilTo(8, textWidth(face.name, 14, true) + 48);
  const needed = faceWidth(face, hexagon);
  if (hexagon) return Math.max(280, ceilTo(16, needed - 8) + 8);
  const usual = face.boxes.length > 0 && style === "simple" ? 288 : 256;
  return Math.max(usual, ceilTo(16, needed));
}

function extent(style: Style, width: number, halves: number[]): { half: number; columns: number[] } {
  const widest = Math.max(48, ...halves);
  switch (style) {
    case "simple":
    case "chip":
      return { half: ceilTo(8, width / 2), columns: [] };
    case "legend":
      return { half: ceilTo(8, Math.max(widest + LEGEND_SIDE, width / 2 + 12)), columns: [0] };
    case "loop":
      // Beside the vertex there is room for the word at its exit.
      return { half: ceilTo(8, Math.max(widest + LOOP_SIDE, width / 2 + 48)), columns: [0] };
    case "bars":
      return bars(width, halves);
    case "columns":
      return columns(width, halves);
  }
}

/** Columns side by side, their middles from the left edge of the first. */
function sideBySide(halves: number[]): { total: number; middles: number[] } {
  let at = 0;
  const middles = halves.map((half) => {
    const middle = at + half;
    at = middle + half + GAP;
    return middle;
  });
  return { total: Math.max(0, at - GAP), middles };
}

/** Branches between bars; the first one leaves room for the name tag, which stands left of its arc and of the middle. */
function bars(tag: number, halves: number[]): { half: number; columns: number[] } {
  const [leftmost = 0, ...others] = halves;
  const { total, middles } = sideBySide([Math.max(leftmost, tag + 8), ...others]);
  const half = ceilTo(8, (total + 16) / 2);
  const first = ceilTo(8, -total / 2 - 7);
  return { half, columns: middles.map((middle) => first + middle) };
}

function columns(width: number, halves: number[]): { half: number; columns: number[] } {
  const { total, middles } = sideBySide(halves);
  const first = ceilTo(8, -total / 2 - 7);
  const clear = ceilTo(8, width / 2 + GAP);
  const last = halves.length - 1;
  // Lines leave the vertex sideways, so no column but a middle one may stand under it.
  const spread = middles.map((middle) => first + middle);
  const left = spread[0] ?? 0;
  const right = spread[last] ?? 0;
  const leftBy = Math.max(0, left + clear);
  const rightBy = Math.max(0, clear - right);
  const moved = spread.map((at, index) => (index < last / 2 ? at - leftBy : index > last / 2 ? at + rightBy : at));
  const reach = moved.reduce((most, at, index) => Math.max(most, Math.abs(at) + (halves[index] ?? 0)), width / 2);
  return { half: ceilTo(8, reach + LEGEND_SIDE), columns: moved };
}
