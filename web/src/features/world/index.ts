/** The world of the mission, drawn and changed. */
import { t } from "../../i18n/words";
import type { Feature } from "../../session/features";
import { keyFor } from "../../session/key-table";
import { openWorld } from "../../session/world-view";
import { menuItem } from "../../ui/menu-model";
import { worldTab } from "./WorldTab";

export const world: Feature = {
  name: "world",
  tab: worldTab,
  commands: { world: () => openWorld() },
  useMenu: () => ({
    team: [menuItem("program-world", t("world.open"), keyFor.page("world"), () => openWorld())],
  }),
};
