/** The map of failures: each robot fails at many moments, and any of these runs can be played. */
import { t } from "../../i18n/words";
import { useBelow } from "../../session/below";
import { complain } from "../../session/document";
import type { Feature } from "../../session/features";
import { later } from "../../ui/later";
import { menuItem } from "../../ui/menu-model";

const SweepPanel = later(() => import("./SweepPanel").then((chunk) => chunk.SweepPanel), complain);

function SweepDock() {
  return useBelow((below) => below.open === "sweep") ? <SweepPanel /> : null;
}

export const sweep: Feature = {
  name: "sweep",
  slots: { below: SweepDock },
  useMenu: () => ({
    sweep: [menuItem("run-sweep", t("run.sweep"), null, () => useBelow.setState({ open: "sweep" }))],
  }),
};
