/**
 * Which constructors are folded, by program: a matter of the view, not of the file. What is selected is never hidden:
 * whatever holds it unfolds.
 */
import { useStudio } from "../../model/studio";
import { findSpot, inChain } from "../../model/tree";
import { currentDrawing } from "../../session/drawing";
import { foldedIn, useFolded } from "../../session/folds";

/** Folds a constructor, or unfolds it. The selection inside it moves to it. */
export function toggleFold(id: string): boolean {
  const drawing = currentDrawing();
  const spot = drawing === null ? undefined : findSpot(drawing.structure, id);
  if (drawing === null || spot === undefined || spot.block.bodies.length === 0) return false;
  const folded = new Set(foldedIn(drawing.program.name));
  if (!folded.delete(id)) {
    folded.add(id);
    const { selection, select } = useStudio.getState();
    if (selection.some((one) => holdersOf(one).includes(id))) select([id]);
  }
  useFolded.getState().set(drawing.program.name, folded);
  return true;
}

/** Folds the selected constructor, or the one that the selected part stands in. */
export function toggleFoldOfSelection(): boolean {
  const last = useStudio.getState().selection.at(-1);
  const drawing = currentDrawing();
  const spot = last === undefined || drawing === null ? undefined : findSpot(drawing.structure, last);
  if (spot === undefined) return false;
  const own = inChain(spot);
  const id = own.block.bodies.length > 0 ? own.block.vertex.id : own.owner?.block.vertex.id;
  return id !== undefined && toggleFold(id);
}

/** The constructors in whose bodies that vertex stands. */
function holdersOf(id: string): string[] {
  const drawing = currentDrawing();
  const spot = drawing === null ? undefined : findSpot(drawing.structure, id);
  const holders: string[] = [];
  if (spot === undefined) return holders;
  for (let at = inChain(spot).owner; at !== null; at = at.owner) holders.push(at.block.vertex.id);
  return holders;
}

useStudio.subscribe((state, before) => {
  if (state.change !== before.change && state.change.kind === "open") useFolded.getState().unfoldAll();
  if (state.selection === before.selection) return;
  const folded = foldedIn(state.activeProgram);
  if (folded.size === 0) return;
  const hiding = new Set(state.selection.flatMap(holdersOf));
  const rest = new Set([...folded].filter((id) => !hiding.has(id)));
  if (rest.size < folded.size) useFolded.getState().set(state.activeProgram, rest);
});
