/** The place where the robots are. */
import { t } from "../../i18n/words";
import type { Feature } from "../../session/features";
import { keyFor } from "../../session/key-table";
import type { MenuEntries } from "../../session/menu-table";
import { openRoom } from "../../session/narrow";
import { useRun } from "../../session/run";
import { setBeside, useStage } from "../../session/stage";
import { menuCheck } from "../../ui/menu-model";
import { Arena } from "./Arena";
import { ARENA_KEYS, PAGE_KEYS } from "./keys";
import { toggleStage, useParts } from "./parts";

function useMenu(): MenuEntries {
  const checked = useStage((stage) => stage.large);
  const key = keyFor.page(PAGE_KEYS.stage);
  return { look: [menuCheck("view-stage", t("arena.large"), checked, toggleStage, key)] };
}

/** Under a small program beside a large arena: the robot that is watched. */
function StageSide() {
  const large = useStage((stage) => stage.large);
  const stage = useParts((parts) => parts.stage);
  return large && stage !== null ? <stage.RobotReadings /> : null;
}

/** Room for what runs: the arena beside the program, on a small window the room of the arena, from the first moment of each run. */
function keepBeside(): () => void {
  return useRun.subscribe((now, before) => {
    if (now.name === before.name) return;
    // Of real robots nobody knows where they are; before the first message there is no run yet, nor has the last one gone.
    if (now.name !== "" && !now.real && now.agents.some(({ placed }) => placed)) {
      setBeside(true);
      openRoom("arena");
    } else if (now.real || now.status === "idle") setBeside(false);
  });
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
