/** What goes wrong in every run, and when: the schedule of failures. */
import { useRef } from "react";

import { setFailures } from "../model/commands/changeTrial";
import { useStudio } from "../model/studio";
import type { ScheduledFailure } from "../model/types";
import { Icon } from "../theme";
import { t } from "../words/words";
import { Chance } from "./Chance";

const KINDS = ["fail", "stall", "mute", "revive"] as const;
const LATEST_S = 1_000_000;
/** When the next failure is proposed: so long after the last one. */
const LATER_S = 10;
const NONE: readonly ScheduledFailure[] = [];

function put(failures: readonly ScheduledFailure[]): void {
  const { mission, execute } = useStudio.getState();
  const command = setFailures(mission, failures);
  if (command !== null) execute(command);
}

function Row({ failure, at, removed }: { failure: ScheduledFailure; at: number; removed: () => void }) {
  const failures = useStudio((studio) => studio.mission.failures ?? NONE);
  const agents = useStudio((studio) => studio.mission.agents);
  const lost = !agents.some((one) => one.name === failure.agent);
  const change = (what: Partial<ScheduledFailure>) => {
    put(failures.map((one, index) => (index === at ? { ...one, ...what } : one)));
  };
  const time = String(failure.at_s);
  const name = t("team.remove-failure", { agent: failure.agent, time });
  const changeTime = (written: string) => {
    const wanted = Number(written);
    if (written.trim() === "" || !Number.isFinite(wanted)) return;
    change({ at_s: Math.round(Math.min(Math.max(wanted, 0), LATEST_S) * 1000) / 1000 });
  };
  return (
    <li className="team-row team-failure" data-testid={`failure-${String(at)}`}>
      <select
        className="field"
        data-testid={`failure-agent-${String(at)}`}
        aria-label={t("team.failure-who")}
        aria-invalid={lost}
        value={failure.agent}
        onChange={(event) => change({ agent: event.target.value })}
      >
        {lost ? <option value={failure.agent}>{t("team.failure-gone", { agent: failure.agent })}</option> : null}
        {agents.map((agent) => (
          <option key={agent.name}>{agent.name}</option>
        ))}
      </select>
      <select
        className="field"
        data-testid={`failure-kind-${String(at)}`}
        aria-label={`${t("team.failure-what")}: ${failure.agent}`}
        value={failure.kind}
        onChange={(event) => change({ kind: KINDS.find((kind) => kind === event.target.value) ?? "fail" })}
      >
        {KINDS.map((kind) => (
          <option key={kind} value={kind}>
            {t(`team.${kind}`)}
          </option>
        ))}
      </select>
      <input
        // Sorted by time once it is left, so that a row does not run away under the fingers.
        key={time}
        className="field"
        type="number"
        min="0"
        max={LATEST_S}
        step="any"
        data-testid={`failure-at-${String(at)}`}
        aria-label={`${t("team.failure-when")}: ${failure.agent}`}
        defaultValue={time}
        onBlur={(event) => changeTime(event.target.value)}
        onKeyDown={(event) => {
          if (event.key === "Enter") changeTime(event.currentTarget.value);
        }}
      />
      <span className="team-tools">
        <button
          type="button"
          className="tool small"
          data-what="remove"
          data-testid={`failure-remove-${String(at)}`}
          aria-label={name}
          title={name}
          onClick={() => {
            put(failures.filter((_, index) => index !== at));
            removed();
          }}
        >
          <Icon name="trash-2" size={16} />
        </button>
      </span>
    </li>
  );
}

export function Failures() {
  const failures = useStudio((studio) => studio.mission.failures ?? NONE);
  const first = useStudio((studio) => studio.mission.agents[0]?.name);
  const button = useRef<HTMLButtonElement>(null);
  const list = useRef<HTMLUListElement>(null);
  const note =
    failures.length > 0 ? "team.failures-help" : first === undefined ? "team.failures-nobody" : "team.failures-none";
  return (
    <section className="team-part" aria-labelledby="team-failures" data-testid="failures">
      <h2 id="team-failures">{t("team.failures")}</h2>
      <p className="team-note">{t(note)}</p>
      {failures.length === 0 ? null : (
        <>
          <div className="team-row team-heads team-failure-heads" aria-hidden="true">
            <span>{t("team.failure-who")}</span>
            <span>{t("team.failure-what")}</span>
            <span>{t("team.failure-when")}</span>
          </div>
          <ul ref={list}>
            {failures.map((failure, at) => (
              <Row
                key={at}
                failure={failure}
                at={at}
                removed={() => requestAnimationFrame(() => button.current?.focus())}
              />
            ))}
          </ul>
        </>
      )}
      <button
        type="button"
        className="button"
        ref={button}
        data-testid="add-failure"
        disabled={first === undefined}
        onClick={() => {
          if (first === undefined) return;
          const { mission } = useStudio.getState();
          const last = mission.failures?.at(-1)?.at_s ?? 0;
          put([...(mission.failures ?? []), { agent: first, at_s: Math.min(last + LATER_S, LATEST_S), kind: "fail" }]);
          requestAnimationFrame(() => list.current?.lastElementChild?.querySelector<HTMLElement>("select")?.focus());
        }}
      >
        <Icon name="plus" size={16} /> {t("team.add-failure")}
      </button>
      <Chance />
    </section>
  );
}
