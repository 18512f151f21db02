/** Tutorials: the one that is open, and all of them as lessons and in the menu. */
import { t } from "../../i18n/words";
import { text } from "../../model/texts";
import type { Feature } from "../../session/features";
import type { MenuEntries } from "../../session/menu-table";
import { setOpenLesson } from "../../session/lessons";
import { setLesson } from "../../session/stage";
import { menuItem } from "../../ui/menu-model";
import { begin } from "./opening";
import { doneSteps } from "./progress";
import { useTutorial } from "./state";
import { Tutorials } from "./Tutorials";

function useMenu(): MenuEntries {
  const usable = (useTutorial(({ all }) => all) ?? []).filter(({ steps }) => steps.length > 0);
  if (usable.length === 0) return {};
  return {
    tutorials: [
      { kind: "heading", id: "help-tutorials", label: t("tutorial.title") },
      ...usable.map((tutorial) =>
        menuItem(`help-tutorial-${tutorial.name}`, text(tutorial.label), null, () => begin(tutorial)),
      ),
    ],
  };
}

/** Says which tutorial is on, and whether all of its steps are done. */
function keepLesson(): () => void {
  return useTutorial.subscribe(({ tutorial, fits, progress }) => {
    setLesson(tutorial !== null);
    const done = tutorial !== null && doneSteps(tutorial, fits, progress).every(Boolean);
    setOpenLesson("tutorial", tutorial === null ? null : { name: tutorial.name, done });
  });
}

export const tutorial: Feature = {
  name: "tutorial",
  slots: { above: Tutorials },
  lessons: () => import("./lessons").then((chunk) => chunk.lessons()),
  useMenu,
  start: keepLesson,
};
