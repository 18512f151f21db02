/** The exercises as lessons of the path to learn. */
import { t } from "../../i18n/words";
import type { Lesson } from "../../session/lesson";
import { begin, lookForExercises, useExercise } from "./exercise-session";

export async function lessons(): Promise<Lesson[]> {
  await lookForExercises();
  return (useExercise.getState().all ?? []).map((exercise) => {
    const { name, order, icon, label, help, start, goals, problems } = exercise;
    return {
      ...{ name, order, icon, label, help, start, problems },
      kind: "exercise",
      teacher: null,
      usable: goals.length > 0,
      far: () => t("exercise.count", { count: goals.length }),
      begin: () => begin(exercise),
    };
  });
}
