/** The layout's interface: from a structure to places, in one linear walk. */
import type { Structure } from "../structure";
import { Placer } from "./place";
import type { Layout } from "./types";

export { NOTE } from "./sizes";
export { distance, distanceToLine, headPath, roundedPath } from "./path";
export type {
  ArcColour,
  ArcLabel,
  Inside,
  Layout,
  LayoutArc,
  LayoutFrame,
  LayoutLeap,
  LayoutNode,
  NodeKind,
  Point,
} from "./types";

/** Lays a program out as a flowchart; of a folded constructor only its vertex is drawn. */
export function layoutStructure(structure: Structure, folded: ReadonlySet<string> = new Set()): Layout {
  return new Placer(folded).layout(structure);
}
