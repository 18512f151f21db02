/** The team: agents, goals, failures and the world they are in. */
import { DockButton } from "../../components/DockButton";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { reportError } from "../../session/document";
import type { Feature, FeatureTab } from "../../session/features";
import { keyFor, type PageKey } from "../../session/key-table";
import { MEMBERS } from "../../session/members";
import { useRun } from "../../session/run";
import { openTeam, teamPlace, useTeam } from "../../session/team-view";
import { later } from "../../ui/later";
import { menuItem } from "../../ui/menu-model";
import { TeamSide } from "./TeamSide";

const Members = later(() => import("./Members").then((chunk) => chunk.Members), reportError);

const KEYS = {
  team: { chords: ["Alt+T"], says: "team.open", also: "search.team", typing: true, run: () => openTeam() },
} satisfies Record<string, PageKey>;

/** The button of the members in the bottom bar, while a team's program runs. */
function MembersButton() {
  const there = useRun((run) => run.team !== null);
  if (!there) return null;
  return (
    <DockButton icon="users" testId="members-button" panel={MEMBERS}>
      {t("members.title")}
    </DockButton>
  );
}

/** The tab behind those of the programs, and the panel that it opens, fetched when it is opened. */
const Team = later(() => import("./Team").then((chunk) => chunk.default), reportError);

const teamTab: FeatureTab = {
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

export const team: Feature = {
  name: "team",
  tab: teamTab,
  panels: { palette: TeamSide },
  docks: { [MEMBERS]: Members },
  slots: { bottom: MembersButton },
  keys: KEYS,
  useMenu: () => ({
    team: [menuItem("program-team", t("team.open"), keyFor.page(KEYS.team), () => openTeam())],
  }),
};
