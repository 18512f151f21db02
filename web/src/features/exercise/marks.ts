/** What is known of each goal: pieces of judging are put together here. */
import type { Exercise, ExerciseGoal, GoalVerdict } from "../../api/generated";
import { t } from "../../i18n/words";

export interface Mark {
  state: "open" | "reached" | "missed";
  /** What went wrong, or how a check knows that nothing can. */
  why: string;
  /** In how many runs a property was kept that no check judged. */
  runs: number;
  /** The run that shows what went wrong, and when in it, in simulated seconds. */
  seed: number | null;
  seconds: number | null;
}

export const OPEN: Mark = { state: "open", why: "", runs: 0, seed: null, seconds: null };

export function noMarks(exercise: Exercise): Mark[] {
  return exercise.goals.map(() => OPEN);
}

/** A goal that one piece found missed stays so; one of which a piece says nothing stays as it was. */
export function withVerdicts(
  marks: readonly Mark[],
  verdicts: readonly GoalVerdict[],
  goals: readonly ExerciseGoal[],
): Mark[] {
  return marks.map((mark, at) => {
    const verdict = verdicts[at];
    if (verdict === undefined || mark.state === "missed") return mark;
    const { reached, why, seed, seconds } = verdict;
    if (reached === null) return why !== "" && mark.state === "open" ? { ...mark, why } : mark;
    if (!reached) return { ...OPEN, state: "missed", why, seed, seconds };
    const kind = goals[at]?.kind;
    const seen = why === "" && (kind === "check" || kind === "watched") ? 1 : 0;
    return { ...OPEN, state: "reached", why, runs: mark.runs + seen };
  });
}

/** Why a goal is missed, or how it is known that it is reached; "" where there is nothing to say. */
export function groundOf({ why, runs }: Mark): string {
  return why === "" && runs > 0 ? t("exercise.seen", { count: runs }) : why;
}

/** The pieces that are asked for one after another: a seed's run each, then what is checked (null). */
export function pieces(exercise: Exercise): (number | null)[] {
  const checks = exercise.goals.some(({ kind }) => kind === "check");
  return checks ? [...exercise.seeds, null] : exercise.seeds;
}
