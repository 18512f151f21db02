/** What goes wrong in every run, and when: the schedule of failures. */
import { NumberInput } from "../../components/fields/NumberInput";
import { t } from "../../i18n/words";
import { setFailures } from "../../model/commands/changeTrial";
import { execute, useStudio } from "../../model/studio";
import type { ScheduledFailure } from "../../model/types";
import { isLive, setFailRate, useRun } from "../../session/run";
import { Select } from "../../ui/Select";
import { RemoveTool, RowList, type RowProps } from "./RowList";

const KINDS = ["fail", "stall", "mute", "apart", "revive"] as const;
const LATEST_S = 1_000_000;
/** When the next failure is proposed: so long after the last one. */
const LATER_S = 10;
const NONE: readonly ScheduledFailure[] = [];

function put(failures: readonly ScheduledFailure[]): void {
  execute(setFailures(useStudio.getState().mission, failures));
}

function Row({ item: failure, at, removed }: RowProps<ScheduledFailure>) {
  const failures = useStudio((studio) => studio.mission.failures ?? NONE);
  const agents = useStudio((studio) => studio.mission.agents);
  const byRadio = useStudio((studio) => studio.mission.radio != null);
  const change = (what: Partial<ScheduledFailure>) => {
    put(failures.map((one, index) => (index === at ? { ...one, ...what } : one)));
  };
  const time = String(failure.at_s);
  return (
    <li className="team-row team-failure gap-m" data-testid={`failure-${String(at)}`}>
      <Select
        label={t("team.failure-who")}
        testId={`failure-agent-${String(at)}`}
        value={failure.agent}
        options={agents.map(({ name }) => name)}
        missing={t("team.failure-gone", { agent: failure.agent })}
        keep={(agent) => change({ agent })}
      />
      <Select
        label={`${t("team.failure-what")}: ${failure.agent}`}
        testId={`failure-kind-${String(at)}`}
        value={failure.kind}
        options={KINDS.filter((kind) => kind !== "apart" || byRadio || failure.kind === kind).map((kind) => [
          kind,
          t(`team.${kind}`),
        ])}
        keep={(wanted) => change({ kind: KINDS.find((kind) => kind === wanted) ?? "fail" })}
      />
      <NumberInput
        // Sorted by time once it is left, so that a row does not run away under the fingers.
        key={time}
        testId={`failure-at-${String(at)}`}
        label={`${t("team.failure-when")}: ${failure.agent}`}
        min={0}
        max={LATEST_S}
        value={failure.at_s}
        keep={(at_s) => change({ at_s: Math.round(at_s * 1000) / 1000 })}
      />
      <RemoveTool
        testId={`failure-remove-${String(at)}`}
        label={t("team.remove-failure", { agent: failure.agent, time })}
        onClick={() => {
          put(failures.filter((_, index) => index !== at));
          removed();
        }}
      />
    </li>
  );
}

export function Failures() {
  const failures = useStudio((studio) => studio.mission.failures ?? NONE);
  const first = useStudio((studio) => studio.mission.agents[0]?.name);
  const add = (agent: string) => {
    const { failures: before = [] } = useStudio.getState().mission;
    const last = before.at(-1)?.at_s ?? 0;
    put([...before, { agent, at_s: Math.min(last + LATER_S, LATEST_S), kind: "fail" }]);
  };
  const note =
    failures.length > 0 ? "team.failures-help" : first === undefined ? "team.failures-nobody" : "team.failures-none";
  return (
    <section className="team-part surface" aria-labelledby="team-failures" data-testid="failures">
      <h2 id="team-failures">{t("team.failures")}</h2>
      <p className="team-note muted">{t(note)}</p>
      <RowList
        items={failures}
        Row={Row}
        heads={
          <div className="team-row team-heads team-failure-heads muted small-text gap-m" aria-hidden="true">
            <span>{t("team.failure-who")}</span>
            <span>{t("team.failure-what")}</span>
            <span>{t("team.failure-when")}</span>
          </div>
        }
        add={{
          testId: "add-failure",
          label: t("team.add-failure"),
          can: first !== undefined,
          run: () => add(first ?? ""),
        }}
      />
      <Chance />
    </section>
  );
}

/** A probability in percent, without a tail of zeros. */
function percentOf(rate: number): number {
  return Math.round(rate * 100_000) / 1000;
}

/**
 * How likely robots fail by chance: part of how the next run is tried out, like its seed, and not of the mission.
 *
 * While a run is on it shows that run's and stays.
 */
export function Chance() {
  const rate = useRun((run) => run.failRate);
  const live = useRun((run) => isLive(run.status));
  return (
    <div className="team-chance">
      <label>
        {t("team.chance")}
        <NumberInput
          testId="fail-rate"
          describedBy="team-chance-help"
          min={0}
          max={100}
          disabled={live}
          value={percentOf(rate)}
          keep={(percent) => setFailRate(Math.round(percent * 1000) / 100_000)}
        />
        <span aria-hidden="true">%</span>
      </label>
      <p className="team-note muted" id="team-chance-help">
        {t("team.chance-help")}
      </p>
    </div>
  );
}
