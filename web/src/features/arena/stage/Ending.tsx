/**
 * How the run ended, as a card: the sentence whole, what else there is to say, and ways on. Beside a small arena it stands
 * under it; on a large one it lies in the corner with the fewest robots. It goes with its ✕ and with the next run.
 */
import CircleCheck from "lucide-react/icons/circle-check";
import CircleX from "lucide-react/icons/circle-x";
import Locate from "lucide-react/icons/locate-fixed";
import Play from "lucide-react/icons/rotate-ccw";
import { useState } from "react";

import { clock } from "../../../i18n/numbers";
import { Said } from "../../../i18n/Said";
import { t } from "../../../i18n/words";
import { useStudio } from "../../../model/studio";
import { can, isEnded, useRun } from "../../../session/run";
import { useStage } from "../../../session/stage";
import { Icon } from "../../../theme";
import { reachedGoal } from "./confetti";
import { causeOf } from "./cause";
import { Button } from "../../../ui/Button";

export function Ending() {
  const run = useRun();
  const large = useStage((stage) => stage.large);
  const [closed, setClosed] = useState("");
  const { sentence, status, name, tick, real } = run;
  if (sentence === "" || real || !isEnded(status) || closed === name) return null;
  const well = status === "done";
  const cause = well ? null : causeOf(run);
  const seeks = can("seek", run);
  const Sign = well ? CircleCheck : CircleX;
  return (
    <section className="stage-ending rigid" data-large={large} data-testid="ending" aria-label={t("arena.result")}>
      <Sign size={20} aria-hidden="true" />
      <div className="stage-ending-words">
        <p>
          <Said text={sentence} />
        </p>
        {reachedGoal(run) ? (
          <p className="stage-ending-more">{t("arena.reached", { time: clock(run.seconds) })}</p>
        ) : null}
        {cause === null || cause.text === "" ? null : (
          <p className="stage-ending-more">
            {t("arena.cause", { time: clock((cause.tick * run.tickMs) / 1000) })} <Said text={cause.text} />
          </p>
        )}
        {seeks ? (
          <span className="stage-ending-ways wrap">
            {cause === null || cause.tick >= tick ? null : (
              <Button
                testId="go-to-cause"
                onClick={() => {
                  const program = run.agents.find((agent) => agent.name === cause.agent)?.program;
                  if (program !== undefined) {
                    useStudio.getState().setActiveProgram(program);
                    run.selectAgent(cause.agent, program);
                  }
                  run.seek(cause.tick);
                }}
              >
                <Locate size={16} aria-hidden="true" />
                {t("arena.go-to-cause")}
              </Button>
            )}
            <Button
              testId="watch-again"
              onClick={() => {
                run.seek(0);
                run.resume();
              }}
            >
              <Play size={16} aria-hidden="true" />
              {t("arena.watch-again")}
            </Button>
          </span>
        ) : null}
      </div>
      <button
        type="button"
        className="tool small rigid"
        aria-label={t("arena.close-result")}
        data-testid="ending-close"
        onClick={() => setClosed(name)}
      >
        <Icon name="x" />
      </button>
    </section>
  );
}
