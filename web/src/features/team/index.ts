/** The team: agents, goals, failures and the world they are in. */
import { t } from "../../i18n/words";
import { complain } from "../../session/document";
import type { Feature } from "../../session/features";
import { keyFor, type PageKey } from "../../session/key-table";
import { MEMBERS } from "../../session/members";
import { openTeam } from "../../session/team-view";
import { later } from "../../ui/later";
import { menuItem } from "../../ui/menu-model";
import { MembersButton } from "./MembersButton";
import { TeamSide } from "./TeamSide";
import { teamTab } from "./TeamTab";

const Members = later(() => import("./Members").then((chunk) => chunk.Members), complain);

const KEYS = {
  team: { chords: ["Alt+T"], says: "team.open", also: "search.team", typing: true, run: () => openTeam() },
} satisfies Record<string, PageKey>;

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
