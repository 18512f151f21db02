/** What the run is doing, at the right of the toolbar: "Paused at 00:42.6", "Done: …". */
import type { AgentActivity } from "../api/wire";
import { type RunStatus as Status, useRun } from "../run/run";
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
};

export function RunStatus() {
  const status = useRun((run) => run.status);
  const sentence = useRun((run) => run.sentence);
  const time = useRun((run) => clock(run.seconds));
  const key: Key = `status.${status}`;
  const timed = status === "running" || status === "paused" || status === "stopped";
  const hit = useRun(({ hits }) => hits[0]);
  const ended = status === "done" || status === "failed" || status === "stuck" || status === "time";
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
      {timed ? (
        <span className="run-status-time" aria-hidden={status === "running"}>
          {time}
        </span>
      ) : null}
    </div>
  );
}
