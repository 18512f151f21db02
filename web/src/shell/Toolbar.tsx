/**
 * The tools under the menus: undo and redo, the run and its speed, what it is doing; STOP at the end.
 *
 * Tools without room give way in the order of their `fold`; a menu at the end has them all.
 */
import { useRef, useState } from "react";

import { runOnRobots, stopEverything } from "../boards/state";
import { useStudio } from "../model/studio";
import { canGoBack, isLive, useRun } from "../run/run";
import { Icon } from "../theme";
import { keyFor } from "../reach/key-table";
import { t } from "../words/words";
import { pause, run, stepVertex } from "./actions";
import { FloatingMenu } from "./FloatingMenu";
import { useFolding } from "./folding";
import { isItem, type MenuPart } from "./menu-model";
import { RunStatus } from "./RunStatus";
import { SpeedControl } from "./SpeedControl";

interface ToolProps {
  icon: string;
  label: string;
  keys?: string;
  disabled?: boolean;
  pressed?: boolean;
  testId?: string;
  fold?: number;
  onPress: () => void;
}

function Tool({ icon, label, keys, disabled = false, pressed, testId, fold, onPress }: ToolProps) {
  return (
    <button
      type="button"
      className="tool"
      aria-label={label}
      title={keys === undefined ? label : `${label} (${keys})`}
      disabled={disabled}
      data-testid={testId}
      data-fold={fold}
      {...(pressed === undefined ? {} : { "aria-pressed": pressed })}
      onClick={onPress}
    >
      <Icon name={icon} size={18} />
    </button>
  );
}

/** What the tools do, from the menus, which say it in words: a menu for those that found no room. */
function MoreTools({ menus }: { menus: MenuPart[] }) {
  const [at, setAt] = useState<{ x: number; y: number } | null>(null);
  const button = useRef<HTMLButtonElement>(null);
  const entries = menus
    .flatMap((menu) => menu.entries)
    .filter((entry) => isItem(entry) && /^(edit-(undo|redo)|run-.*|robots-run)$/.test(entry.id));
  return (
    <span data-folded="2">
      <button
        type="button"
        className="tool"
        ref={button}
        aria-label={t("tools.more")}
        title={t("tools.more")}
        aria-haspopup="menu"
        aria-expanded={at !== null}
        data-testid="more-tools"
        onClick={(event) => {
          const box = event.currentTarget.getBoundingClientRect();
          setAt({ x: box.left, y: box.bottom + 4 });
        }}
      >
        <Icon name="ellipsis" size={18} />
      </button>
      {at === null ? null : (
        <FloatingMenu
          id="more-tools"
          label={t("tools.more")}
          at={at}
          entries={entries}
          onLeave={() => setAt(null)}
          onClose={() => {
            setAt(null);
            button.current?.focus();
          }}
        />
      )}
    </span>
  );
}

export function Toolbar({ menus }: { menus: MenuPart[] }) {
  const tools = useRef<HTMLDivElement>(null);
  useFolding(tools);
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
    <div className="toolbar">
      <div className="tools" role="toolbar" aria-label={t("menu.run")} ref={tools}>
        <Tool
          icon="undo-2"
          label={undoLabel === "" ? t("edit.undo") : t("edit.undo-what", { what: undoLabel })}
          keys={keyFor.page("undo")}
          disabled={!canUndo}
          testId="undo"
          fold={9}
          onPress={undo}
        />
        <Tool
          icon="redo-2"
          label={redoLabel === "" ? t("edit.redo") : t("edit.redo-what", { what: redoLabel })}
          keys={keyFor.page("redo")}
          disabled={!canRedo}
          testId="redo"
          fold={7}
          onPress={redo}
        />
        <span className="tool-line" data-fold={9} />
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
          fold={8}
          onPress={pause}
        />
        <Tool
          icon="step-back"
          label={t("run.step-back")}
          keys={keyFor.page("stepBack")}
          disabled={!goesBack}
          testId="step-back-button"
          fold={3}
          onPress={() => useRun.getState().step("tick", true)}
        />
        <Tool
          icon="step-forward"
          label={t("run.step")}
          keys={keyFor.page("step")}
          disabled={!paused}
          testId="step-button"
          fold={4}
          onPress={() => useRun.getState().step()}
        />
        <Tool
          icon="redo-dot"
          label={t("run.step-vertex")}
          keys={keyFor.page("stepVertex")}
          disabled={!paused}
          testId="step-vertex-button"
          fold={2}
          onPress={() => stepVertex(false)}
        />
        <Tool
          icon="square"
          label={t(watching ? "watching.leave" : "run.stop")}
          keys={keyFor.page("stop")}
          disabled={!live}
          testId="stop-button"
          fold={6}
          onPress={stopEverything}
        />
        <span className="tool-line" data-fold={5} />
        <SpeedControl />
        <span className="tool-line" data-fold={5} />
        <button
          type="button"
          className="tool tool-named"
          data-testid="run-on-robot"
          data-fold={5}
          aria-label={t("boards.run")}
          title={`${t("boards.run")} (${keyFor.page("runOnRobot")})`}
          onClick={runOnRobots}
        >
          <Icon name="upload" size={18} />
          <span data-fold={1}>{t("boards.run")}</span>
        </button>
        <MoreTools menus={menus} />
      </div>
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
