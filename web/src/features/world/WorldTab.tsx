/** The tab behind the team's, and the panel that it opens, fetched then. */
import { lazy, Suspense } from "react";

import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { thingNamed } from "../../model/world/thing";
import type { FeatureTab } from "../../session/features";
import { useTeam } from "../../session/team-view";
import { openWorld } from "../../session/world-view";

const World = lazy(() => Promise.all([import("./World"), moreWords()]).then(([chunk]) => chunk));

export const worldTab: FeatureTab = {
  name: "world",
  icon: "map",
  label: "world.tab",
  isOpen: () => useTeam.getState().world,
  open: () => openWorld(),
  useTab: () => ({
    open: useTeam((team) => team.world),
    errors: useStudio(
      ({ report, mission }) =>
        report?.problems.some(
          (one) => one.severity === "error" && thingNamed(mission.own_world, one.thing) !== null,
        ) === true,
    ),
  }),
  Panel: WorldPanel,
};

/** The world over the canvas, which stays as it is underneath. */
function WorldPanel() {
  const open = useTeam((team) => team.world);
  if (!open) return null;
  return (
    <Suspense fallback={null}>
      <World />
    </Suspense>
  );
}
