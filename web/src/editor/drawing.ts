/** What is drawn of a program: its structure and layout, made once for each program and shared by all who ask. */
import { type Layout, type LayoutNode, layoutStructure } from "../model/layout";
import { type Parts, partsOf } from "../model/parts";
import { readStructure, type Structure } from "../model/structure";
import { programInView, type StudioState, useStudio } from "../model/studio";
import type { Program } from "../model/types";
import { languageInUse } from "../words/words";

export interface Drawing {
  program: Program;
  parts: Parts;
  /** Shared: to be read only. */
  structure: Structure;
  layout: Layout;
  nodes: Map<string, LayoutNode>;
  /** Words are in the layout: another language is another drawing. */
  language: string;
}

const made = new WeakMap<Program, Drawing>();

/** The drawing of the program in view, or null while nothing is open. */
export function drawingOf(state: StudioState): Drawing | null {
  const program = programInView(state);
  if (program === undefined) return null;
  const parts = partsOf(state.catalogue, program.robot);
  const known = made.get(program);
  const language = languageInUse();
  if (known?.parts === parts && known.language === language) return known;
  const structure = readStructure(program, parts);
  const layout = layoutStructure(structure);
  const nodes = new Map(layout.nodes.map((node) => [node.id, node]));
  const drawing = { program, parts, structure, layout, nodes, language };
  made.set(program, drawing);
  return drawing;
}

export function useDrawing(): Drawing | null {
  return useStudio(drawingOf);
}

/** The drawing as it stands, for what happens outside of rendering. */
export function currentDrawing(): Drawing | null {
  return drawingOf(useStudio.getState());
}
