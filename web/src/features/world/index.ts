/** The world of the mission, drawn and changed. */
import { t } from "../../i18n/words";
import type { Feature } from "../../session/features";
import { keyFor, type PageKey } from "../../session/key-table";
import { openWorld } from "../../session/world-view";
import { menuItem } from "../../ui/menu-model";
import { WORLD_KEYS } from "./keys";
import { worldTab } from "./WorldTab";

const KEYS = {
  world: { chords: ["Alt+W"], says: "world.open", also: "search.world", typing: true, run: () => openWorld() },
} satisfies Record<string, PageKey>;

export const world: Feature = {
  name: "world",
  tab: worldTab,
  keys: KEYS,
  keyTables: [{ heading: "world.tab", rows: WORLD_KEYS }],
  useMenu: () => ({
    team: [menuItem("program-world", t("world.open"), keyFor.page(KEYS.world), () => openWorld())],
  }),
};
