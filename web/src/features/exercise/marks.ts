/** What is known of each goal, as pure functions: pieces of judging are put together here. */
import type { Exercise, GoalVerdict } from "../../api/generated";

export interface Mark {
  state: "open" | "reached" | "missed";
  why: string;
  /** The run that shows what went wrong, and when in it, in simulated seconds. */
  seed: number | null;
  seconds: number | null;
}

export const OPEN: Mark = { state: "open", why: "", seed: null, seconds: null };

export function noMarks(exercise: Exercise): Mark[] {
  return exercise.goals.map(() => OPEN);
}

/** A goal that one piece found missed stays so; one of which a piece says nothing stays as it was. */
export function withVerdicts(marks: readonly Mark[], verdicts: readonly GoalVerdict[]): Mark[] {
  return marks.map((mark, at) => {
    const verdict = verdicts[at];
    if (verdict === undefined || verdict.reached === null || mark.state === "missed") return mark;
    const { reached, why, seed, seconds } = verdict;
    return reached ? { ...OPEN, state: "reached" } : { state: "missed", why, seed, seconds };
  });
}

/** The pieces that are asked for one after another: a seed's run each, then what is checked (null). */
export function pieces(exercise: Exercise): (number | null)[] {
  const checks = exercise.goals.some(({ kind }) => kind === "check");
  return checks ? [...exercise.seeds, null] : exercise.seeds;
}
