/** The door of the layout: a structure in, places out, in one linear walk. */
import type { Structure } from "../structure";
import { Placer } from "./place";
import type { Layout } from "./types";

export { distance, distanceToLine, headPath, roundedPath } from "./path";
export type { ArcColour, ArcLabel, Layout, LayoutArc, LayoutFrame, LayoutNode, NodeKind, Point } from "./types";

/** Lays a program out as a flowchart. */
export function layoutStructure(structure: Structure): Layout {
  return new Placer().layout(structure);
}
