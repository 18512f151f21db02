/** The door of the layout: a structure in, places out, in one linear walk. */
import type { Structure } from "../structure";
import { type LayoutWords, Placer } from "./place";
import type { Layout } from "./types";

export { distance, distanceToLine, headPath, roundedPath } from "./path";
export type { ArcColour, ArcLabel, Layout, LayoutArc, LayoutFrame, LayoutNode, NodeKind, Point } from "./types";

/** Lays a program out as a flowchart; `words` are those of ours that it writes beside arcs. */
export function layoutStructure(structure: Structure, words: LayoutWords = { done: "done" }): Layout {
  return new Placer(words).layout(structure);
}
