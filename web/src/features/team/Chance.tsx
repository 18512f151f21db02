/**
 * How likely robots fail by chance: part of how the next run is tried out, like its seed, and not of the mission.
 *
 * While a run is on it shows that run's and stays.
 */
import { NumberInput } from "../../components/fields/NumberInput";
import { t } from "../../i18n/words";
import { isLive, setFailRate, useRun } from "../../session/run";

/** A probability in percent, without a tail of zeros. */
function percentOf(rate: number): number {
  return Math.round(rate * 100_000) / 1000;
}

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
