/** A layout while it is being made: what has been placed so far, and how each thing is written down. */
import type { Colour, Vertex } from "../types";
import { Leaps } from "./break-edges";
import { boundsOf } from "./path";
import { HALF_ROW, type Measured } from "./sizes";
import type {
  ArcColour,
  ArcLabel,
  Layout,
  LayoutArc,
  LayoutFrame,
  LayoutLane,
  LayoutNode,
  NodeKind,
  Point,
} from "./types";

const ORIGIN = { x: 0, y: 0, w: 0, h: 0 };

/** An arc that is not at its end yet. */
export interface Piece {
  source: string;
  out: string;
  colour: ArcColour;
  /** Keeps its colour whoever takes it: the exit of a loop. */
  fixed: boolean;
  points: Point[];
  label: ArcLabel | null;
  /** Leaves a Break. */
  dead: boolean;
}

export const NO_FACE = { object: "", name: "", boxes: [], chips: [] };

export function startPiece(source: string, out: string, colour: ArcColour, from: Point): Piece {
  return { source, out, colour, fixed: false, points: [from], label: null, dead: false };
}

export class Draft {
  readonly nodes: LayoutNode[] = [];
  readonly frames: LayoutFrame[] = [];
  readonly lanes: LayoutLane[] = [];
  readonly arcs: LayoutArc[] = [];
  readonly leaps = new Leaps();
  /** Whether what comes now hangs on nothing. */
  parked = false;

  finished(): Layout {
    const { nodes, frames, lanes, arcs } = this;
    return { nodes, frames, lanes, arcs, leaps: this.leaps.done, bounds: boundsOf([ORIGIN, ...nodes, ...frames]) };
  }

  /** Writes arcs that follow each other; the last of them may end in a head. */
  emit(pieces: Piece[], head = true, missing = false): void {
    pieces.forEach(({ source, out, colour, points, label, dead }, index) => {
      const last = index === pieces.length - 1;
      this.arcs.push({
        id: `${source}.${out}`,
        source,
        out,
        colour,
        points: straightened(points),
        head: last && head,
        label,
        missing: last && missing,
        dead,
      });
    });
  }

  terminal(vertex: Vertex, kind: "start" | "stop", middle: number, note: string): void {
    const box = { x: -60, y: middle - HALF_ROW, w: 120, h: 2 * HALF_ROW };
    const face = { ...NO_FACE, name: vertex.element };
    const common = {
      face,
      block: null,
      mark: null,
      parked: false,
      inside: null,
      note,
      noteWidth: 256,
      colour: "action" as const,
    };
    this.nodes.push({ id: vertex.id, vertex: vertex.id, ...box, kind, ...common });
  }

  node({ shown, mark, face, width, inside, note }: Measured, kind: NodeKind, x: number, middle: number): void {
    const { id } = shown.vertex;
    const h = kind === "chip" ? 28 : 2 * HALF_ROW;
    const box = { x: x - width / 2, y: middle - h / 2, w: width, h };
    this.nodes.push({
      id,
      vertex: id,
      ...box,
      kind,
      colour: shown.shape.colour,
      face,
      block: shown,
      mark,
      parked: this.parked,
      inside,
      note,
      noteWidth: Math.min(480, Math.max(256, width)),
    });
  }

  /** Where something is to be dropped. `id` is that of the arc that it stands on, or "place" in an empty program. */
  place(id: string, colour: Colour, box: { x: number; y: number; w: number; h: number }): void {
    const nothing = { vertex: "", face: NO_FACE, block: null, mark: null, inside: null, note: "", noteWidth: 0 };
    this.nodes.push({ id, ...box, kind: "place", colour, parked: this.parked, ...nothing });
  }

  bar({ shown, face, half, width, note }: Measured, kind: "bar" | "barEnd", x: number, y: number): void {
    const { id } = shown.vertex;
    this.nodes.push({
      id: kind === "bar" ? id : `${id}:end`,
      vertex: id,
      x: x - half,
      y: y - 14,
      w: 2 * half,
      h: 28,
      kind,
      colour: shown.shape.colour,
      face,
      block: shown,
      mark: null,
      parked: this.parked,
      inside: null,
      note: kind === "bar" ? note : "",
      // The name tag stands on the left of the middle.
      noteWidth: Math.min(480, Math.max(120, 2 * (half - width - 16))),
    });
  }

  frame(kind: LayoutFrame["kind"], id: string, colour: Colour, x: number, y: number, w: number): LayoutFrame {
    const frame = { id, kind, colour, x, y, w, h: 0 };
    this.frames.push(frame);
    return frame;
  }

  /** The right edge of all that is there. */
  right(): number {
    return [...this.nodes, ...this.frames].reduce((most, { x, w }) => Math.max(most, x + w), 0);
  }
}

/** Without points that lie on the line between their neighbours. */
function straightened(points: Point[]): Point[] {
  return points.filter((point, index) => {
    const before = points[index - 1];
    const after = points[index + 1];
    if (before === undefined || after === undefined) return true;
    const repeated = point.x === before.x && point.y === before.y;
    return (
      !repeated && !(before.x === point.x && point.x === after.x) && !(before.y === point.y && point.y === after.y)
    );
  });
}
