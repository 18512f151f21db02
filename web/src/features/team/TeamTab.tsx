/** The tab behind those of the programs, and the panel that it opens, fetched when it is opened. */
import { lazy, Suspense } from "react";

import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import type { FeatureTab } from "../../session/features";
import { openTeam, teamPlace, useTeam } from "../../session/team-view";

const Team = lazy(() => Promise.all([import("./Team"), moreWords()]).then(([chunk]) => chunk));

export const teamTab: FeatureTab = {
  name: "team",
  icon: "users",
  label: "team.tab",
  isOpen: () => useTeam.getState().open,
  open: () => openTeam(),
  useTab: () => ({
    open: useTeam((team) => team.open),
    count: useStudio((studio) => studio.mission.agents.length),
    errors: useStudio(
      ({ report, mission }) =>
        report?.problems.some((one) => one.severity === "error" && teamPlace(one, mission) !== null) === true,
    ),
  }),
  Panel: TeamPanel,
};

/** The team over the canvas, which stays as it is underneath. */
function TeamPanel() {
  const open = useTeam((team) => team.open);
  if (!open) return null;
  return (
    <Suspense fallback={null}>
      <Team />
    </Suspense>
  );
}
