/** The panel of the experiment: a study is set up on the one side, and looked at on the other, or below it. */
import { useEffect, useRef } from "react";

import { DockPanel } from "../../components/DockPanel";
import { Refused } from "../../components/Refused";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { useVaried } from "../../session/varied";
import { Button } from "../../ui/Button";
import { useWidth } from "../../ui/use-width";
import { Progress } from "./Progress";
import { Results } from "./Results";
import { Setup } from "./Setup";
import { fetchChoices, useStudy } from "./study-work";
import "./experiment.css";

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
    const timer = setTimeout(() => void fetchChoices(stop.signal), QUIET_MS);
    return () => {
      clearTimeout(timer);
      stop.abort();
    };
  }, [mission, path]);
  const setup = (
    <div key="setup" className="experiment-setup column" ref={place}>
      {busy === null ? <Setup /> : <Progress {...busy} />}
    </div>
  );
  const results = (
    <div key="results" className="experiment-results column">
      <Refused refused={refused} />
      {study === null ? (
        <p className="experiment-note muted">{t("experiment.empty")}</p>
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
      <div className="experiment-body" ref={box} data-narrow={isNarrow}>
        {/* One below the other, what came of a study is above what is chosen for the next one, and below its progress. */}
        {isNarrow && study !== null && busy === null ? [results, setup] : [setup, results]}
      </div>
    </DockPanel>
  );
}
