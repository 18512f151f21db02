/** Check: what can go wrong in the mission, whatever the order of events; a broken property is played as a run. */
import { moreWords, t } from "../../i18n/words";
import { useBelow } from "../../session/below";
import { complain } from "../../session/document";
import type { Feature } from "../../session/features";
import { keyFor } from "../../session/key-table";
import { later } from "../../ui/later";
import { menuItem } from "../../ui/menu-model";

const CheckPanel = later(
  () => Promise.all([import("./CheckPanel"), moreWords()]).then(([chunk]) => chunk.CheckPanel),
  complain,
);

function CheckDock() {
  return useBelow((below) => below.open === "check") ? <CheckPanel /> : null;
}

const open = () => useBelow.setState({ open: "check" });

export const check: Feature = {
  name: "check",
  slots: { below: CheckDock },
  commands: { check: open },
  useMenu: () => ({ sweep: [menuItem("run-check", t("run.check"), keyFor.page("check"), open)] }),
};
