/** The panel of the experiment: a study is set up on the one side, and looked at on the other, or below it. */
import "./experiment.css";

import { useEffect, useRef } from "react";

import { DockPanel } from "../../components/DockPanel";
import { Refusal } from "../../components/Refusal";
import { clock, grouped } from "../../i18n/numbers";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { useVaried } from "../../session/varied-axes";
import { Button } from "../../ui/Button";
import { afterPause, endAll } from "../../ui/effects";
import { useWidth } from "../../ui/use-width";
import { Results } from "./Results";
import { Setup } from "./Setup";
import { breakOff, fetchChoices, useStudy } from "./study-work";

/** How long the mission stays as it is before it is asked what it has. */
const QUIET_MS = 300;
/** In less both sides do not fit beside each other; a picture of a study has more room below it, too. */
const NARROW_PX = 600;
const NARROW_WITH_PICTURE_PX = 1000;

export function ExperimentPanel() {
  const mission = useStudio((studio) => studio.mission);
  const path = useStudio((studio) => studio.file.path);
  const refused = useStudy((state) => state.refused);
  const busy = useStudy((state) => state.busy);
  const study = useStudy((state) => state.study);
  const [box, width] = useWidth<HTMLDivElement>(NARROW_PX);
  const isNarrow = width < (study === null ? NARROW_PX : NARROW_WITH_PICTURE_PX);
  const place = useRef<HTMLDivElement>(null);
  const varied = useVaried(({ axes }) => axes.length);
  const before = useRef(varied);
  const showSetup = () => place.current?.scrollIntoView({ block: "start" });
  useEffect(() => {
    // Whoever marks a number is shown it among those that vary.
    if (varied > before.current) showSetup();
    before.current = varied;
  }, [varied]);
  useEffect(() => {
    const stop = new AbortController();
    return endAll(
      afterPause(QUIET_MS, () => void fetchChoices(stop.signal)),
      () => stop.abort(),
    );
  }, [mission, path]);
  const setup = (
    <div key="setup" className="column slim gap-m" ref={place}>
      {busy === null ? <Setup /> : <Progress {...busy} />}
    </div>
  );
  const results = (
    <div key="results" className="column slim gap-m">
      <Refusal refused={refused} />
      {study === null ? (
        <p className="prose muted">{t("experiment.empty")}</p>
      ) : (
        <Results study={study}>
          {isNarrow && busy === null ? (
            <Button icon="plus" testId="experiment-next" onClick={showSetup}>
              {t("experiment.next")}
            </Button>
          ) : null}
        </Results>
      )}
    </div>
  );
  return (
    <DockPanel id="experiment-panel" testId="experiment" title={t("experiment.title")} close={t("experiment.close")}>
      <div className="experiment-body dock-body gap-2xl" ref={box} data-narrow={isNarrow}>
        {/* One below the other, what came of a study is above what is chosen for the next one, and below its progress. */}
        {isNarrow && study !== null && busy === null ? [results, setup] : [setup, results]}
      </div>
    </DockPanel>
  );
}

/** How far the work on a study is, and what is left of it. */
function Progress({ done, total, left }: { done: number; total: number; left: number | null }) {
  const said =
    total === 0 ? t("experiment.preparing") : t("experiment.progress", { done: grouped(done), total: grouped(total) });
  return (
    <div className="experiment-progress column gap-m items-start" data-testid="experiment-progress">
      <progress aria-label={said} max={Math.max(total, 1)} {...(total === 0 ? {} : { value: done })} />
      <p className="figures">
        {said}
        {left === null || done >= total ? null : (
          <span className="muted"> {t("experiment.left", { time: clock(left) })}</span>
        )}
      </p>
      <Button icon="square" testId="experiment-break-off" onClick={breakOff}>
        {t("experiment.break-off")}
      </Button>
    </div>
  );
}
