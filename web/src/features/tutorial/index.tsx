/** Tutorials: the list of them, and the one that is open. */
import { useEffect } from "react";

import { t } from "../../i18n/words";
import { text } from "../../model/texts";
import { complain } from "../../session/document";
import type { Feature } from "../../session/features";
import type { MenuEntries } from "../../session/menu-table";
import { setLesson } from "../../session/stage";
import { later } from "../../ui/later";
import { menuItem } from "../../ui/menu-model";
import { begin, lookForTutorials } from "./opening";
import { useTutorial } from "./state";
import { Tutorials } from "./Tutorials";

const Cards = later(() => import("./Cards").then((chunk) => chunk.TutorialCards), complain);
const Invitation = later(() => import("./Cards").then((chunk) => chunk.Invitation), complain);

/** In the sheet for opening. */
function AllCards() {
  useEffect(() => void lookForTutorials(), []);
  return <Cards />;
}

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

export const tutorial: Feature = {
  name: "tutorial",
  slots: { above: Tutorials, "open-lists": AllCards },
  panels: { "empty-program": Invitation },
  useMenu,
  start: () => useTutorial.subscribe(({ tutorial }) => setLesson(tutorial !== null)),
};
