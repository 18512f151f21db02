/** The experiment: numbers of the mission vary, many runs are made, and the run behind each dot can be played. */
import { t } from "../../i18n/words";
import { openDock } from "../../session/dock";
import { reportError } from "../../session/document";
import type { Feature } from "../../session/features";
import { EXPERIMENT } from "../../session/varied-axes";
import { later } from "../../ui/later";
import { menuItem } from "../../ui/menu-model";

const ExperimentPanel = later(() => import("./ExperimentPanel").then((chunk) => chunk.ExperimentPanel), reportError);

export const experiment: Feature = {
  name: "experiment",
  docks: { [EXPERIMENT]: ExperimentPanel },
  words: { "run-experiment": "search.experiment" },
  useMenu: () => ({
    sweep: [menuItem("run-experiment", t("run.experiment"), null, () => openDock(EXPERIMENT))],
  }),
};
