/** The tab behind the team's, and the panel that it opens, fetched then. */
import { useStudio } from "../../model/studio";
import { thingNamed } from "../../model/world/thing";
import { complain } from "../../session/document";
import type { FeatureTab } from "../../session/features";
import { useTeam } from "../../session/team-view";
import { openWorld } from "../../session/world-view";
import { later } from "../../ui/later";

const World = later(() => import("./World").then((chunk) => chunk.default), complain);

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
  return useTeam((team) => team.world) ? <World /> : null;
}
