/** The panel of the experiment: a study is set up on the one side, and looked at on the other. */
import { useEffect } from "react";

import { DockPanel } from "../../components/DockPanel";
import { Refused } from "../../components/Refused";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { useWidth } from "../../ui/use-width";
import { Progress } from "./Progress";
import { Results } from "./Results";
import { Setup } from "./Setup";
import { fetchChoices, useStudy } from "./study-work";
import "./experiment.css";

/** How long the mission stays as it is before it is asked what it has. */
const QUIET_MS = 300;
/** In less both sides do not fit beside each other. */
const NARROW_PX = 600;

export function ExperimentPanel() {
  const mission = useStudio((studio) => studio.mission);
  const path = useStudio((studio) => studio.file.path);
  const refused = useStudy((state) => state.refused);
  const busy = useStudy((state) => state.busy);
  const study = useStudy((state) => state.study);
  const [box, width] = useWidth<HTMLDivElement>(NARROW_PX);
  const isNarrow = width < NARROW_PX;
  useEffect(() => {
    const stop = new AbortController();
    const timer = setTimeout(() => void fetchChoices(stop.signal), QUIET_MS);
    return () => {
      clearTimeout(timer);
      stop.abort();
    };
  }, [mission, path]);
  const setup = (
    <div key="setup" className="column slim gap-m">
      {busy === null ? <Setup /> : <Progress {...busy} />}
    </div>
  );
  const results = (
    <div key="results" className="column slim gap-m">
      <Refused refused={refused} />
      {study === null ? <p className="prose muted">{t("experiment.empty")}</p> : <Results study={study} />}
    </div>
  );
  return (
    <DockPanel id="experiment-panel" testId="experiment" title={t("experiment.title")} close={t("experiment.close")}>
      <div className="experiment-body dock-body gap-2xl" ref={box} data-narrow={isNarrow}>
        {/* One below the other, what came of a study is above what is chosen for the next one. */}
        {isNarrow && study !== null ? [results, setup] : [setup, results]}
      </div>
    </DockPanel>
  );
}
