/** Check: what can go wrong in the mission, whatever the order of events; a broken property is played as a run. */
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { openDock } from "../../session/dock";
import { reportError } from "../../session/document";
import type { Feature } from "../../session/features";
import { keyFor, type PageKey } from "../../session/key-table";
import { later } from "../../ui/later";
import { menuItem } from "../../ui/menu-model";

const CheckPanel = later(() => import("./CheckPanel").then((chunk) => chunk.CheckPanel), reportError);

const RunJudgements = later(() => import("./RunJudgements").then((chunk) => chunk.RunJudgements), reportError);

const open = () => openDock("check-panel");

const KEYS = {
  check: { chords: ["Alt+C"], says: "run.check", also: "search.verify", typing: true, run: open },
} satisfies Record<string, PageKey>;

/** The check while one draws is fetched at the first edit. */
function start(): () => void {
  let over = false;
  let end = useStudio.subscribe((state, before) => {
    if (state.mission === before.mission || state.change.kind === "open") return;
    end();
    import("./drawing").then(
      ({ checkWhileDrawing }) => {
        if (!over) end = checkWhileDrawing();
      },
      () => undefined,
    );
  });
  return () => {
    over = true;
    end();
  };
}

export const check: Feature = {
  name: "check",
  docks: { "check-panel": CheckPanel },
  panels: { ending: RunJudgements },
  keys: KEYS,
  start,
  useMenu: () => ({ sweep: [menuItem("run-check", t("run.check"), keyFor.page(KEYS.check), open)] }),
};
