/** Exercises: a mission to begin with, and its goals as a checklist beside the work. */
import { complain } from "../../session/document";
import type { Feature } from "../../session/features";
import { later } from "../../ui/later";
import { useOpenExercise } from "../../session/open-exercise";

const ExercisePanel = later(() => import("./Panel").then((chunk) => chunk.ExercisePanel), complain);

function ExerciseDock() {
  return useOpenExercise(({ open }) => open !== null) ? <ExercisePanel /> : null;
}

export const exercise: Feature = {
  name: "exercise",
  slots: { above: ExerciseDock },
  lessons: () => import("./lessons").then((chunk) => chunk.lessons()),
};
