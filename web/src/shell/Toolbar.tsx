/** The tools under the menus: undo and redo, the run and its speed, what it is doing; STOP at the end. */
import { runOnRobots, stopEverything } from "../boards/state";
import { useStudio } from "../model/studio";
import { canGoBack, isLive, useRun } from "../run/run";
import { Icon } from "../theme";
import { keyFor } from "../reach/key-table";
import { t } from "../words/words";
import { pause, run, stepVertex } from "./actions";
import { RunStatus } from "./RunStatus";
import { SpeedControl } from "./SpeedControl";

interface ToolProps {
  icon: string;
  label: string;
  keys?: string;
  disabled?: boolean;
  pressed?: boolean;
  testId?: string;
  onPress: () => void;
}

function Tool({ icon, label, keys, disabled = false, pressed, testId, onPress }: ToolProps) {
  return (
    <button
      type="button"
      className="tool"
      aria-label={label}
      title={keys === undefined ? label : `${label} (${keys})`}
      disabled={disabled}
      data-testid={testId}
      {...(pressed === undefined ? {} : { "aria-pressed": pressed })}
      onClick={onPress}
    >
      <Icon name={icon} size={18} />
    </button>
  );
}

export function Toolbar() {
  const { canUndo, canRedo, undoLabel, redoLabel } = useStudio();
  const { undo, redo } = useStudio.getState();
  const status = useRun((state) => state.status);
  const watching = useRun((state) => state.watching);
  const real = useRun((state) => state.real);
  const goesBack = useRun((state) => canGoBack(state.status) && state.tick > 0 && !state.watching && !state.real);
  // What another page steers is not paused here, whatever it does there.
  const paused = status === "paused" && !watching;
  const live = isLive(status);
  return (
    <div className="toolbar" role="toolbar" aria-label={t("menu.run")}>
      <Tool
        icon="undo-2"
        label={undoLabel === "" ? t("edit.undo") : t("edit.undo-what", { what: undoLabel })}
        keys={keyFor.page("undo")}
        disabled={!canUndo}
        testId="undo"
        onPress={undo}
      />
      <Tool
        icon="redo-2"
        label={redoLabel === "" ? t("edit.redo") : t("edit.redo-what", { what: redoLabel })}
        keys={keyFor.page("redo")}
        disabled={!canRedo}
        testId="redo"
        onPress={redo}
      />
      <span className="tool-line" />
      <button
        type="button"
        className="run-button"
        data-testid="run-button"
        disabled={live && !paused}
        title={`${paused ? t("run.resume") : t("run.run")} (${keyFor.page("run")})`}
        onClick={run}
      >
        <Icon name="play" size={16} />
        {paused ? t("run.resume") : t("run.run")}
      </button>
      <Tool
        icon="pause"
        label={t("run.pause")}
        keys={keyFor.page("pause")}
        disabled={(status !== "running" || watching || real) && !paused}
        pressed={paused}
        testId="pause-button"
        onPress={pause}
      />
      <Tool
        icon="step-back"
        label={t("run.step-back")}
        keys={keyFor.page("stepBack")}
        disabled={!goesBack}
        testId="step-back-button"
        onPress={() => useRun.getState().step("tick", true)}
      />
      <Tool
        icon="step-forward"
        label={t("run.step")}
        keys={keyFor.page("step")}
        disabled={!paused}
        testId="step-button"
        onPress={() => useRun.getState().step()}
      />
      <Tool
        icon="redo-dot"
        label={t("run.step-vertex")}
        keys={keyFor.page("stepVertex")}
        disabled={!paused}
        testId="step-vertex-button"
        onPress={() => stepVertex(false)}
      />
      <Tool
        icon="square"
        label={t(watching ? "watching.leave" : "run.stop")}
        keys={keyFor.page("stop")}
        disabled={!live}
        testId="stop-button"
        onPress={stopEverything}
      />
      <span className="tool-line" />
      <SpeedControl />
      <span className="tool-line" />
      <button
        type="button"
        className="tool tool-named"
        data-testid="run-on-robot"
        title={`${t("boards.run")} (${keyFor.page("runOnRobot")})`}
        onClick={runOnRobots}
      >
        <Icon name="upload" size={18} />
        <span>{t("boards.run")}</span>
      </button>
      <RunStatus />
    </div>
  );
}

/** The one red thing: ends the run and with it every robot of the team, from anywhere. */
export function TeamStop() {
  return (
    <button
      type="button"
      className="team-stop"
      data-testid="team-stop"
      title={`${t("stop.label")} (${keyFor.page("stop")})`}
      onClick={stopEverything}
    >
      <Icon name="octagon-x" size={24} />
      <span>
        <strong>{t("stop.big")}</strong>
        <small>{t("stop.small")}</small>
      </span>
    </button>
  );
}
