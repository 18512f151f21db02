/** What the open run of a check says about vertices: where a property is broken, and which steps pass by. */
import { create } from "zustand";

import { useStudio } from "../model/studio";

/** One vertex of the run that is open. */
export interface CounterexampleMark {
  program: string;
  vertex: string;
  /** What happens there; "" where the run only passes by, or where another mark says it. */
  sentence: string;
  /** Whether it goes on for ever, and whose robots do; [] where it is passed by. */
  robots: readonly string[];
  repeats: boolean;
  /** The last steps in which it is come to. */
  steps: readonly number[];
}

export const useCounterexample = create<{ marks: readonly CounterexampleMark[] }>(() => ({ marks: [] }));

export function markVertices(marks: readonly CounterexampleMark[]): void {
  useCounterexample.setState({ marks });
}

/** The mark of a vertex of the program in view. */
export function useMarkAt(vertex: string): CounterexampleMark | undefined {
  const program = useStudio((studio) => studio.activeProgram);
  return useCounterexample(({ marks }) => marks.find((one) => one.vertex === vertex && one.program === program));
}

/** Whether a property is broken in that program. */
export function useHasCounterexample(program: string): boolean {
  return useCounterexample(({ marks }) => marks.some((one) => one.program === program && one.robots.length > 0));
}
