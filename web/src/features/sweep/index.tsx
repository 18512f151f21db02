/** The map of failures: each robot fails at many moments, and any of these runs can be played. */
import { moreWords, t } from "../../i18n/words";
import { complain } from "../../session/document";
import type { Feature } from "../../session/features";
import { later } from "../../ui/later";
import { menuItem } from "../../ui/menu-model";
import { useSweepPanel } from "./panel";

const SweepPanel = later(
  () => Promise.all([import("./SweepPanel"), moreWords()]).then(([chunk]) => chunk.SweepPanel),
  complain,
);

function SweepDock() {
  return useSweepPanel((panel) => panel.open) ? <SweepPanel /> : null;
}

export const sweep: Feature = {
  name: "sweep",
  slots: { below: SweepDock },
  useMenu: () => ({
    sweep: [menuItem("run-sweep", t("run.sweep"), null, () => useSweepPanel.setState({ open: true }))],
  }),
};
