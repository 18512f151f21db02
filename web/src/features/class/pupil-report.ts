/** What a pupil's page reports of itself: what runs, how much was done, how far the exercise is. */
import type { ReportMessage } from "../../api/generated";
import { useStudio } from "../../model/studio";
import { shownName } from "../../session/document";
import { useOpenExercise } from "../../session/open-exercise";
import { useRun } from "../../session/run";

export function reportOf(counts: { edits: number; runs: number }): ReportMessage {
  const { open, goals } = useOpenExercise.getState();
  return {
    type: "report",
    running: useRun.getState().status === "running",
    ...counts,
    file: shownName(useStudio.getState().file.name).slice(0, 200),
    exercise: open?.name ?? "",
    goals: open === null ? [] : goals.slice(0, 100).map(({ reached, why }) => ({ reached, why: why.slice(0, 500) })),
  };
}
