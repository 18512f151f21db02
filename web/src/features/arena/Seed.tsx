/**
 * The seed of the next run: where its chance begins. The same seed gives the same run; another one another run.
 *
 * A number that can be typed, and dice for a random one. While a run is on it shows that run's and stays.
 */
import "./seed.css";

import { NumberInput } from "../../components/fields/NumberInput";
import { decimal } from "../../i18n/numbers";
import { t } from "../../i18n/words";
import { isHardwareRun, isLive, setSeed, useRun } from "../../session/run";
import { Icon } from "../../theme";
import { Tool } from "../../ui/Tool";

const LARGEST = 999_999;

function put(seed: number): void {
  setSeed(seed);
}

export function Seed() {
  const seed = useRun((run) => run.seed);
  const failRate = useRun((run) => run.failRate);
  const live = useRun((run) => isLive(run.status));
  // Chance has no seed where real robots run.
  const real = useRun((run) => (run.recording || isLive(run.status)) && isHardwareRun(run.agents));
  if (real) return null;
  return (
    <span className="seed inline-row gap-xs">
      <label title={t("run.seed-help")}>
        {t("run.seed")}
        <NumberInput testId="seed" min={0} max={LARGEST} whole disabled={live} value={seed} keep={put} />
      </label>
      <Tool
        small
        icon="dices"
        label={t("run.new-seed")}
        testId="new-seed"
        disabled={live}
        onClick={() => put(1 + Math.floor(Math.random() * LARGEST))}
      />
      {failRate > 0 ? (
        <span
          className="seed-chance small-text inline-row nowrap gap-xs"
          data-testid="chance-on"
          title={t("team.chance-on", { percent: decimal(failRate * 100) })}
        >
          <Icon name="circle-x" size={14} />
          <bdi dir="ltr" aria-hidden="true">
            {decimal(failRate * 100)} %
          </bdi>
          <span className="only-spoken">{t("team.chance-on", { percent: decimal(failRate * 100) })}</span>
        </span>
      ) : null}
    </span>
  );
}
