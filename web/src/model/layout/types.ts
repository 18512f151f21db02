/** What the layout gives: where everything is, in px at zoom 1. The middle of Start is the origin; y grows downwards. */
import type { Block } from "../structure";
import type { Colour } from "../types";
import type { Face } from "../vertex-content";

export interface Point {
  x: number;
  y: number;
}

export interface Box extends Point {
  w: number;
  h: number;
}

/** What a folded constructor holds. */
export interface Inside {
  /** How many parts stand in its bodies. */
  count: number;
  /** All their vertices. */
  vertices: string[];
}

export type NodeKind = "start" | "stop" | "rect" | "hexagon" | "bar" | "barEnd" | "chip" | "place";

export interface LayoutNode {
  /** The vertex's id; the second bar of a parallel has ":end" after it. */
  id: string;
  vertex: string;
  x: number;
  y: number;
  w: number;
  h: number;
  kind: NodeKind;
  colour: Colour;
  face: Face;
  /** The block that is shown, or null for Start, Stop and the place of an empty program. */
  block: Block | null;
  /** The mark around it (a badge), if any: arcs leave and enter by the mark's id. */
  mark: Block | null;
  parked: boolean;
  /** What is hidden in it, or null when it is not folded. */
  inside: Inside | null;
  /** The note above it ("" for none): a strip NOTE high on its top edge, `noteWidth` wide. */
  note: string;
  noteWidth: number;
}

/** A tinted box around bodies, drawn under everything else; owners come before what they hold. */
export interface LayoutFrame {
  id: string;
  kind: "loop" | "parallel" | "legend" | "parked";
  colour: Colour;
  x: number;
  y: number;
  w: number;
  h: number;
}

/** A branch of a parallel in a team's program: who acts in it, under the first bar, `LANE` high. */
export interface LayoutLane {
  /** The parallel's vertex and the branch: "SOURCE.OUT". */
  id: string;
  /** Whether it has nothing on its left: the first of its parallel. */
  first: boolean;
  /** The roles, groups and agents that what stands in it speaks of; none where it speaks of nobody. */
  names: readonly string[];
  x: number;
  y: number;
  w: number;
  h: number;
}

export interface ArcLabel {
  text: string;
  x: number;
  y: number;
  anchor: "start" | "end";
}

export type ArcColour = Colour | "flow";

export interface LayoutArc {
  /** "SOURCE.OUT". */
  id: string;
  source: string;
  out: string;
  points: Point[];
  colour: ArcColour;
  /** Whether it ends in an arrowhead: not where another arc takes over. */
  head: boolean;
  label: ArcLabel | null;
  /** A place for an arc that is not there yet: the end of a parked chain, a body that does not return. */
  missing: boolean;
  /** Nothing ever goes along it: it leaves a Break. */
  dead: boolean;
}

/** Where a Break leads: drawn only, not an arc of the graph. */
export interface LayoutLeap {
  /** The Break's vertex. */
  source: string;
  points: Point[];
  colour: Colour;
  label: ArcLabel;
}

export interface Layout {
  nodes: LayoutNode[];
  frames: LayoutFrame[];
  lanes: LayoutLane[];
  arcs: LayoutArc[];
  leaps: LayoutLeap[];
  bounds: Box;
}
