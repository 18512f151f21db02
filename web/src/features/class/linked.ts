/** A link of the teacher's that opens an exercise on a pupil's page, with what the pupil did on it before. */
import { classApi } from "../../api/class";
import { ApiError } from "../../api/client";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { note, reportError } from "../../session/document";
import { readExerciseLink } from "../../session/exercise-link";
import { workedOn } from "../../session/open-exercise";
import { forgetHash } from "../../ui/page-hash";
import { exerciseOffer } from "./pupil-offers";

interface Opening {
  /** The name of the class; "" while it does not answer. */
  className: string;
  /** Whether work on that exercise waits here to be handed in: it is newer than what the class has. */
  waits: (exercise: string) => boolean;
  openWork: (name: string, exercise: string) => Promise<void>;
}

/** Opens what the address names, if it names something: the work that the class has, what is open, or a new beginning. */
export async function openLinked({ className, waits, openWork }: Opening): Promise<void> {
  const link = readExerciseLink(window.location.hash);
  if (link === null) return;
  forgetHash();
  if (className !== "" && link.className !== "" && link.className !== className) {
    note(t("class.other-link", { wanted: link.className, name: className }), t("class.other-link-help"));
    return;
  }
  const found = await exerciseOffer(link.exercise, className !== "");
  if (found?.open == null) {
    reportError(new ApiError(t("exercise.no-link", { name: link.exercise }), t("exercise.no-link-help")));
    return;
  }
  if (workedOn(useStudio.getState().file) === link.exercise) return;
  const works = className === "" || waits(link.exercise) ? [] : await classApi.works();
  const work = works.find(({ exercise }) => exercise === link.exercise);
  if (work === undefined) found.open();
  else await openWork(work.name, link.exercise);
}
