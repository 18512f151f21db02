/** What is drawn of a program: its structure and layout, made once for each program and shared by all who ask. */
import { languageInUse } from "../i18n/words";
import { type Layout, type LayoutNode, layoutStructure } from "../model/layout";
import { type Parts, partsOf } from "../model/parts";
import { readStructure, type Structure } from "../model/structure";
import { programInView, type StudioState, useStudio } from "../model/studio";
import { actingIn } from "../model/team-names";
import { TEAM_ROBOT } from "../model/team-robot";
import { findSpot, type Spot } from "../model/tree";
import type { Program } from "../model/types";
import { foldedIn, useFolded } from "./folds";

export interface Drawing {
  program: Program;
  parts: Parts;
  /** Shared: to be read only. */
  structure: Structure;
  layout: Layout;
  nodes: Map<string, LayoutNode>;
  /** Words are in the layout: another language is another drawing. */
  language: string;
  folded: ReadonlySet<string>;
}

const made = new WeakMap<Program, Drawing & { lanes: string }>();

const acting = new WeakMap<object, { catalogue: unknown; of: ReturnType<typeof actingIn> }>();

/** Who acts where in a team's program; that depends on its other programs too. */
function actingOf({ mission: { programs }, catalogue }: StudioState, program: Program) {
  if (program.robot !== TEAM_ROBOT) return undefined;
  const known = acting.get(programs);
  if (known?.catalogue === catalogue) return known.of.get(program.name);
  const of = actingIn(programs, catalogue);
  acting.set(programs, { catalogue, of });
  return of.get(program.name);
}

/** The drawing of the program in view, or null while nothing is open. */
export function drawingOf(state: StudioState): Drawing | null {
  const program = programInView(state);
  return program === undefined ? null : drawProgram(state, program);
}

/** The drawing of any program of the open mission. */
export function drawProgram(state: StudioState, program: Program): Drawing {
  const parts = partsOf(state.catalogue, program.robot);
  const known = made.get(program);
  const language = languageInUse();
  const folded = foldedIn(program.name);
  const names = actingOf(state, program);
  const lanes = names === undefined ? "" : JSON.stringify([...names]);
  if (known?.parts === parts && known.language === language && known.folded === folded && known.lanes === lanes)
    return known;
  const structure = readStructure(program, parts);
  const layout = layoutStructure(structure, folded, names);
  const nodes = new Map(layout.nodes.map((node) => [node.id, node]));
  const drawing = { program, parts, structure, layout, nodes, language, folded, lanes };
  made.set(program, drawing);
  return drawing;
}

/** What shows a vertex: its own node, or the one of the vertex that holds it in a slot. */
export function nodeOf({ layout, structure }: Drawing, id: string): LayoutNode | undefined {
  const own = layout.nodes.find((node) => node.vertex === id);
  if (own !== undefined) return own;
  for (let spot: Spot | null = findSpot(structure, id) ?? null; spot !== null; spot = spot.owner) {
    const { id: outer } = spot.block.vertex;
    const node = layout.nodes.find((one) => one.vertex === outer || one.mark?.vertex.id === outer);
    if (node !== undefined) return node;
  }
  return undefined;
}

export function useDrawing(): Drawing | null {
  // A fold makes another drawing of the same program.
  useFolded((state) => state.folded);
  return useStudio(drawingOf);
}

/** The drawing as it stands, for what happens outside of rendering. */
export function currentDrawing(): Drawing | null {
  return drawingOf(useStudio.getState());
}
