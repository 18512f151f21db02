/** What the run is doing, at the right of the toolbar: "Paused at 00:42.6", "Done: …". */
import type { AgentActivity } from "../api/wire";
import { useStudio } from "../model/studio";
import type { Mission } from "../model/types";
import { isLive, type RunStatus as Status, useRun } from "../run/run";
import { Icon } from "../theme";
import { Said } from "../words/Said";
import { type Key, t } from "../words/words";
import { clock } from "../words/numbers";
import { StateShape } from "./StateShape";

const SHAPES: Record<Status, AgentActivity> = {
  idle: "idle",
  connecting: "waiting",
  running: "running",
  paused: "waiting",
  done: "running",
  failed: "failed",
  stuck: "failed",
  time: "failed",
  stopped: "idle",
  end: "idle",
};

/** Whether a run of one would be another run than that of the other; breakpoints reach the run that is on. */
function isAnother(mission: Mission, running: Mission): boolean {
  const parts = ["programs", "agents", "goals", "world", "constructors", "variables", "failures"] as const;
  return parts.some((part) => mission[part] !== running[part]);
}

export function RunStatus() {
  const status = useRun((run) => run.status);
  const sentence = useRun((run) => run.sentence);
  const time = useRun((run) => clock(run.seconds));
  const real = useRun((run) => run.real);
  const key: Key = real && status === "running" ? "boards.on-robot" : `status.${status}`;
  const timed = status === "running" || status === "paused" || status === "stopped";
  const running = useRun((run) => (isLive(run.status) && !run.watching ? run.mission : null));
  const edited = useStudio(({ mission }) => running !== null && isAnother(mission, running));
  const hit = useRun(({ hits }) => hits[0]);
  const ended = status === "done" || status === "failed" || status === "stuck" || status === "time" || status === "end";
  return (
    <div className="run-status" data-testid="status" data-status={status} title={ended ? sentence : undefined}>
      <StateShape state={SHAPES[status]} />
      <span className="run-status-words" role="status">
        {ended && sentence !== "" ? (
          <Said text={sentence} />
        ) : hit !== undefined && status === "paused" ? (
          t("debug.paused-at", { agent: hit.agent, visit: hit.visit })
        ) : (
          t(key)
        )}
      </span>
      {edited ? (
        <span
          className="run-status-edited"
          role="img"
          aria-label={t("run.edited-since")}
          title={t("run.edited-since")}
          data-testid="edited-since"
        >
          <Icon name="pencil" size={14} />
        </span>
      ) : null}
      {timed ? (
        <span className="run-status-time" aria-hidden={status === "running"}>
          {time}
        </span>
      ) : null}
    </div>
  );
}
