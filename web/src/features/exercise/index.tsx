/** Exercises: a mission to begin with, and its goals as a checklist beside the work. */
import { pageRole } from "../../api/token";
import { reportError } from "../../session/document";
import { readExerciseLink } from "../../session/exercise-link";
import type { Feature } from "../../session/features";
import { useOpenExercise } from "../../session/open-exercise";
import { later } from "../../ui/later";
import { watchHash } from "../../ui/page-hash";

const ExercisePanel = later(() => import("./Panel").then((chunk) => chunk.ExercisePanel), reportError);

function ExerciseDock() {
  return useOpenExercise(({ open }) => open !== null) ? <ExercisePanel /> : null;
}

/** Opens the exercise of a link. */
function follow(hash: string): void {
  const link = readExerciseLink(hash);
  if (link === null) return;
  import("./exercise-session").then((chunk) => chunk.openLinked(link.exercise)).catch(reportError);
}

export const exercise: Feature = {
  name: "exercise",
  slots: { above: ExerciseDock },
  // In a class the pupil's page follows it, which knows what was handed in.
  start: () => (pageRole === "" ? watchHash(follow) : () => undefined),
  lessons: () => import("./lessons").then((chunk) => chunk.lessons()),
};
