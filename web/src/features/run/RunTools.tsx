/** The tools of the run: begin, pause, step, stop, and its speed. */
import { t } from "../../i18n/words";
import { pause, run, stepVertex } from "../../session/actions";
import { useDocument } from "../../session/document";
import { STOP_KEY, stopEverything } from "../../session/features";
import { keyFor } from "../../session/key-table";
import { can, isLive, useRun } from "../../session/run";
import { useShown } from "../../session/simple-view";
import { Icon } from "../../theme";
import { Tool } from "../../ui/Tool";
import { SpeedControl } from "./SpeedControl";
import { KEYS } from "./keys";

/** One tick back, and one on. */
function TickTools({ paused }: { paused: boolean }) {
  const goesBack = useRun((state) => can("seek", state) && state.tick > 0);
  return (
    <>
      <Tool
        icon="step-back"
        label={t("run.step-back")}
        keys={keyFor.page(KEYS.stepBack)}
        disabled={!goesBack}
        testId="step-back-button"
        data-fold={3}
        onClick={() => useRun.getState().step("tick", true)}
      />
      <Tool
        icon="step-forward"
        label={t("run.step")}
        keys={keyFor.page(KEYS.step)}
        disabled={!paused}
        testId="step-button"
        data-fold={4}
        onClick={() => useRun.getState().step()}
      />
    </>
  );
}

export function RunTools() {
  const status = useRun((state) => state.status);
  const watching = useRun((state) => state.watching);
  const ticks = useShown("ticks");
  // What another page steers is not paused here, whatever it does there.
  const paused = status === "paused" && !watching;
  const live = isLive(status);
  const choosing = useDocument(({ overlay }) => overlay === "new");
  return (
    <>
      <button
        type="button"
        className="run-button bold rigid inline-row ink justify-centre"
        data-testid="run-button"
        disabled={(live && !paused) || choosing}
        title={`${paused ? t("run.resume") : t("run.run")} (${keyFor.page(KEYS.run)})`}
        onClick={run}
      >
        <span className="run-face" data-other={t(paused ? "run.run" : "run.resume")}>
          <span className="inline-row">
            <Icon name="play" size={16} />
            {t(paused ? "run.resume" : "run.run")}
          </span>
        </span>
      </button>
      <Tool
        icon="pause"
        label={t("run.pause")}
        keys={keyFor.page(KEYS.pause)}
        disabled={(status !== "running" || watching) && !paused}
        aria-pressed={paused}
        testId="pause-button"
        data-fold={8}
        onClick={pause}
      />
      {ticks ? <TickTools paused={paused} /> : null}
      <Tool
        icon="redo-dot"
        label={t("run.step-vertex")}
        keys={keyFor.page(KEYS.stepVertex)}
        disabled={!paused}
        testId="step-vertex-button"
        data-fold={2}
        onClick={() => stepVertex(false)}
      />
      <Tool
        icon="square"
        label={t(watching ? "watching.leave" : "run.stop")}
        keys={keyFor.page(STOP_KEY)}
        disabled={!live}
        testId="stop-button"
        data-fold={6}
        onClick={stopEverything}
      />
      <span className="tool-line rigid" data-fold={5} />
      <SpeedControl />
    </>
  );
}
