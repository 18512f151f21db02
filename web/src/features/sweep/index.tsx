/** The map of failures: each robot fails at many moments, and any of these runs can be played. */
import { t } from "../../i18n/words";
import { openDock } from "../../session/dock";
import { reportError } from "../../session/document";
import type { Feature } from "../../session/features";
import { later } from "../../ui/later";
import { menuItem } from "../../ui/menu-model";

const SweepPanel = later(() => import("./SweepPanel").then((chunk) => chunk.SweepPanel), reportError);

export const sweep: Feature = {
  name: "sweep",
  docks: { "sweep-panel": SweepPanel },
  words: { "run-sweep": "search.faults" },
  useMenu: () => ({
    sweep: [menuItem("run-sweep", t("run.sweep"), null, () => openDock("sweep-panel"))],
  }),
};
