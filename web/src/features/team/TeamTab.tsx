/** The tab behind those of the programs, and the panel that it opens, fetched when it is opened. */
import { useStudio } from "../../model/studio";
import { complain } from "../../session/document";
import type { FeatureTab } from "../../session/features";
import { openTeam, teamPlace, useTeam } from "../../session/team-view";
import { later } from "../../ui/later";

const Team = later(() => import("./Team").then((chunk) => chunk.default), complain);

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
  return useTeam((team) => team.open) ? <Team /> : null;
}
