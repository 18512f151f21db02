/** The tutorials as lessons of the path to learn. */
import type { Tutorial } from "../../api/generated";
import { t } from "../../i18n/words";
import type { Lesson } from "../../session/lesson";
import { begin, lookForTutorials } from "./opening";
import { rememberedProgress } from "./progress";
import { useTutorial } from "./state";

/** How much there is to do, or which step comes next. */
function far(tutorial: Tutorial): string {
  const total = tutorial.steps.length;
  const at = rememberedProgress(tutorial)?.at ?? total;
  return at >= total ? t("tutorial.count", { count: total }) : t("tutorial.at", { number: at + 1, total });
}

export async function lessons(): Promise<Lesson[]> {
  await lookForTutorials();
  return (useTutorial.getState().all ?? []).map((tutorial) => {
    const { name, order, icon, label, help, start, teacher, problems } = tutorial;
    return {
      ...{ name, order, icon, label, help, start, teacher, problems },
      kind: "tutorial",
      usable: tutorial.steps.length > 0,
      far: () => far(tutorial),
      begin: () => void begin(tutorial),
    };
  });
}
