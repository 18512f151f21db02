/** The world of the mission, drawn and changed. */
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { thingNamed } from "../../model/world/part-reference";
import { reportError } from "../../session/document";
import type { Feature, FeatureTab } from "../../session/features";
import { keyFor, type PageKey } from "../../session/key-table";
import { useTeam } from "../../session/team-view";
import { openWorld } from "../../session/world-view";
import { later } from "../../ui/later";
import { menuItem } from "../../ui/menu-model";
import { WORLD_KEYS } from "./keys";

const KEYS = {
  world: { chords: ["Alt+W"], says: "world.open", also: "search.world", typing: true, run: () => openWorld() },
} satisfies Record<string, PageKey>;

/** The tab behind the team's, and the panel that it opens, fetched then. */
const World = later(() => import("./World").then((chunk) => chunk.default), reportError);

const worldTab: FeatureTab = {
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

export const world: Feature = {
  name: "world",
  tab: worldTab,
  keys: KEYS,
  keyTables: [{ heading: "world.tab", rows: WORLD_KEYS }],
  useMenu: () => ({
    team: [menuItem("program-world", t("world.open"), keyFor.page(KEYS.world), () => openWorld())],
  }),
};
