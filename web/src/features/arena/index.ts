/** The place where the robots are. */
import { t } from "../../i18n/words";
import type { Feature } from "../../session/features";
import { keyFor } from "../../session/key-table";
import type { MenuEntries } from "../../session/menu-table";
import { useStage } from "../../session/stage";
import { Arena } from "./Arena";
import { keepBeside } from "./beside";
import { ARENA_KEYS, PAGE_KEYS } from "./keys";
import { toggleStage } from "./parts";
import { StageSide } from "./StageSide";

function useMenu(): MenuEntries {
  const checked = useStage((stage) => stage.large);
  const label = t("arena.large");
  return {
    look: [{ kind: "check", id: "view-stage", label, keys: keyFor.page(PAGE_KEYS.stage), checked, run: toggleStage }],
  };
}

export const arena: Feature = {
  name: "arena",
  panels: { arena: Arena },
  slots: { below: StageSide },
  keys: PAGE_KEYS,
  keyTables: [{ heading: "view.arena", rows: ARENA_KEYS }],
  elsewhere: [{ name: "elsewhere.gamepad-name", says: "elsewhere.gamepad", also: "search.gamepad" }],
  useMenu,
  start: keepBeside,
};
