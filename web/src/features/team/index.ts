/** The team: agents, goals, failures and the world they are in. */
import { t } from "../../i18n/words";
import type { Feature } from "../../session/features";
import { keyFor } from "../../session/key-table";
import { openTeam } from "../../session/team-view";
import { menuItem } from "../../ui/menu-model";
import { MembersButton, MembersDock } from "./MembersDock";
import { TeamSide } from "./TeamSide";
import { teamTab } from "./TeamTab";

export const team: Feature = {
  name: "team",
  tab: teamTab,
  panels: { palette: TeamSide },
  slots: { below: MembersDock, bottom: MembersButton },
  commands: { team: () => openTeam() },
  useMenu: () => ({
    team: [menuItem("program-team", t("team.open"), keyFor.page("team"), () => openTeam())],
  }),
};
