/** A run that could not start says why: the list of problems opens, at the first of them. */
import { useProblemList } from "../problems/walk";
import { useRun } from "../run/run";

/** Watches for it; the returned function ends that. */
export function showRunProblems(): () => void {
  return useRun.subscribe((run, before) => {
    if (run.problems !== before.problems && run.problems.length > 0) useProblemList.setState({ open: true, at: 0 });
  });
}
