/** The layout's interface: from a structure to places, in one linear walk. */
import type { Structure } from "../structure";
import { type Acting, Placer } from "./place";
import type { Layout } from "./types";

export { LANE, NOTE } from "./sizes";
export { boundsOf, distance, distanceToLine, headPath, hexagonPoints, roundedPath } from "./path";
export type {
  ArcColour,
  ArcLabel,
  Box,
  Inside,
  Layout,
  LayoutArc,
  LayoutFrame,
  LayoutLane,
  LayoutLeap,
  LayoutNode,
  NodeKind,
  Point,
} from "./types";

/**
 * Lays a program out as a flowchart; of a folded constructor only its vertex is drawn.
 *
 * @param acting of vertices of a team's program: who does what stands there. Branches in which somebody acts are lanes.
 */
export function layoutStructure(
  structure: Structure,
  folded: ReadonlySet<string> = new Set(),
  acting: Acting = new Map(),
): Layout {
  return new Placer(folded, acting).layout(structure);
}
