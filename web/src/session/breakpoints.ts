/**
 * Breakpoints of the open program: set and taken away, told to a run that is on, and what happens when one is reached.
 *
 * A breakpoint stands at an instruction; that of a marked action is the action's. Left to others: reaching it (the server).
 */
import { breakpointAt, removeBreakpoint, setBreakpoint } from "../model/commands/changeBreakpoints";
import type { LayoutNode } from "../model/layout";
import { isMark } from "../model/parts";
import { execute, useStudio } from "../model/studio";
import { findSpot, inChain } from "../model/tree";
import type { Breakpoint } from "../model/types";
import { endAll } from "../ui/effects";
import { currentDrawing, type Drawing, nodeOf } from "./drawing";
import { isQueryable, useRun } from "./run";

/** The vertex whose instruction holds that one: a condition's is what waits for it. Null for start and stop. */
export function instructionOf(drawing: Drawing, id: string): string | null {
  const spot = findSpot(drawing.structure, id);
  if (spot === undefined) return null;
  const { block } = inChain(spot);
  return isMark(block.shape) ? (block.plugs[0]?.block?.vertex.id ?? null) : block.vertex.id;
}

/** The breakpoint of a drawn vertex, or undefined. */
export function useBreakpoint({ vertex }: LayoutNode): Breakpoint | undefined {
  return useStudio(({ mission, activeProgram }) => breakpointAt(mission, activeProgram, vertex));
}

/** Sets breakpoints at the selected instructions, or takes them away where all have one. False when there are none. */
export function toggleBreakpoints(): boolean {
  const drawing = currentDrawing();
  const { selection } = useStudio.getState();
  if (drawing === null) return false;
  const ids = [...new Set(selection.flatMap((id) => instructionOf(drawing, nodeOf(drawing, id)?.vertex ?? id) ?? []))];
  if (ids.length === 0) return false;
  const program = drawing.program.name;
  const has = (id: string) => breakpointAt(useStudio.getState().mission, program, id) !== undefined;
  const all = ids.every(has);
  for (const vertex of ids) {
    const { mission } = useStudio.getState();
    if (all) execute(removeBreakpoint(mission, program, vertex));
    else if (!has(vertex)) execute(setBreakpoint(drawing.parts, mission, { program, vertex }));
  }
  return true;
}

/** Sends changed breakpoints to the run, and shows where it pauses; the returned function ends that. */
export function followBreakpoints(reveal: (program: string, vertices: string[]) => void): () => void {
  return endAll(
    useStudio.subscribe(({ mission }, before) => {
      const [now, then] = [mission.breakpoints ?? NONE, before.mission.breakpoints ?? NONE];
      const run = useRun.getState();
      if (now !== then && (run.status === "connecting" || isQueryable(run))) run.pauseAt(now);
    }),
    useRun.subscribe(({ hits, selectAgent }, before) => {
      const [hit] = hits;
      if (hit === undefined || hits === before.hits) return;
      selectAgent(hit.agent, hit.program);
      reveal(hit.program, [hit.vertex]);
    }),
  );
}

const NONE: Breakpoint[] = [];
