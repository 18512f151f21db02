/** Exercises: a mission to begin with, and its goals as a checklist beside the work. */
import { reportError } from "../../session/document";
import type { Feature } from "../../session/features";
import { useOpenExercise } from "../../session/open-exercise";
import { later } from "../../ui/later";

const ExercisePanel = later(() => import("./Panel").then((chunk) => chunk.ExercisePanel), reportError);

function ExerciseDock() {
  return useOpenExercise(({ open }) => open !== null) ? <ExercisePanel /> : null;
}

export const exercise: Feature = {
  name: "exercise",
  slots: { above: ExerciseDock },
  lessons: () => import("./lessons").then((chunk) => chunk.lessons()),
};
