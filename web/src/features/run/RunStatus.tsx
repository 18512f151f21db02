/** What the run is doing, at the right of the toolbar: "Paused at 00:42.6", "Done: …". */
import { type RefObject, useLayoutEffect, useRef, useState } from "react";

import type { AgentActivity } from "../../api/wire";
import { StateShape } from "../../components/StateShape";
import { clock } from "../../i18n/numbers";
import { Said } from "../../i18n/Said";
import { type Key, t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import type { Mission } from "../../model/types";
import { isLive, type RunStatus as Status, useRun } from "../../session/run";
import { Icon } from "../../theme";
import { Tool } from "../../ui/Tool";
import { watchLayout } from "../../ui/watch-layout";

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

/** Whether the words take more lines than they have. */
function useCut(words: RefObject<HTMLElement | null>): boolean {
  const [cut, setCut] = useState(false);
  useLayoutEffect(() => {
    const element = words.current;
    if (element === null) return;
    return watchLayout(element, () => setCut(element.scrollHeight > element.clientHeight + 1));
  }, [words]);
  return cut;
}

/** A sentence that is too long for its place is opened, over what stands below. */
function Whole({ text }: { text: string }) {
  const [open, setOpen] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  return (
    <span
      className="rigid"
      onKeyDown={(event) => {
        if (event.key !== "Escape" || !open) return;
        event.stopPropagation();
        setOpen(false);
        button.current?.focus();
      }}
      onBlur={(event) => {
        if (!event.currentTarget.contains(event.relatedTarget)) setOpen(false);
      }}
    >
      <Tool
        small
        icon="ellipsis"
        ref={button}
        label={t("status.whole")}
        testId="status-more"
        aria-expanded={open}
        onClick={() => setOpen(!open)}
      />
      {open ? (
        <span className="run-status-whole surface breakable scroll" tabIndex={-1} data-testid="status-whole">
          <Said text={text} />
        </span>
      ) : null}
    </span>
  );
}

export function RunStatus() {
  const words = useRef<HTMLSpanElement>(null);
  const cut = useCut(words);
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
  const said =
    ended && sentence !== ""
      ? sentence
      : hit !== undefined && status === "paused"
        ? t("debug.paused-at", { agent: hit.agent, visit: hit.visit })
        : t(key);
  return (
    <div className="run-status row relative justify-end" data-testid="status" data-status={status} title={said}>
      <StateShape state={SHAPES[status]} />
      <span className="run-status-words breakable" role="status" ref={words}>
        <Said text={said} />
      </span>
      {cut ? <Whole text={said} /> : null}
      {edited ? (
        <span role="img" aria-label={t("run.edited-since")} title={t("run.edited-since")} data-testid="edited-since">
          <Icon name="pencil" size={14} />
        </span>
      ) : null}
      {timed ? (
        <span className="run-status-time bold" aria-hidden={status === "running"}>
          {time}
        </span>
      ) : null}
    </div>
  );
}
