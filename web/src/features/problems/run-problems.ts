/**
 * A run that could not start, or ended before anything could be seen, says why: the list of problems opens, at the first
 * of them. They were true of the mission that was to run; once that is edited the checker's own report says what is left
 * of them.
 */
import { useStudio } from "../../model/studio";
import { showFirstProblem } from "../../session/problem-walk";
import { forgetRunProblems, useRun } from "../../session/run";

/** Watches for it; the returned function ends that. */
export function showRunProblems(): () => void {
  const offRun = useRun.subscribe((run, before) => {
    if (run.problems !== before.problems && run.problems.length > 0) showFirstProblem();
  });
  const offMission = useStudio.subscribe((state, before) => {
    if (state.mission !== before.mission) forgetRunProblems();
  });
  return () => {
    offRun();
    offMission();
  };
}
