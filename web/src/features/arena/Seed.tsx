/**
 * The seed of the next run: where its chance begins. The same seed gives the same run; another one another run.
 *
 * A number that can be typed, and dice for a random one. While a run is on it shows that run's and stays.
 */
import "./seed.css";

import { useState } from "react";

import { decimal } from "../../i18n/numbers";
import { t } from "../../i18n/words";
import { areReal, isLive, useRun } from "../../session/run";
import { Icon } from "../../theme";
import { Tool } from "../../ui/Tool";

const LARGEST = 999_999;

export function Seed() {
  const seed = useRun((run) => run.seed);
  const failRate = useRun((run) => run.failRate);
  const live = useRun((run) => isLive(run.status));
  // Chance has no seed where real robots run.
  const real = useRun((run) => (run.recording || isLive(run.status)) && areReal(run.agents));
  const [typed, setTyped] = useState<string | null>(null);
  const put = (wanted: number) => {
    if (Number.isInteger(wanted) && wanted >= 0 && wanted <= LARGEST) useRun.setState({ seed: wanted });
  };
  const keep = () => {
    if (typed !== null && typed.trim() !== "") put(Number(typed));
    setTyped(null);
  };
  if (real) return null;
  return (
    <span className="seed">
      <label title={t("run.seed-help")}>
        {t("run.seed")}
        <input
          type="text"
          inputMode="numeric"
          data-testid="seed"
          maxLength={6}
          disabled={live}
          value={typed ?? String(seed)}
          onFocus={(event) => {
            setTyped(String(seed));
            event.target.select();
          }}
          onChange={(event) => setTyped(event.target.value.replace(/\D/g, ""))}
          onBlur={keep}
          onKeyDown={(event) => {
            if (event.key === "Enter") event.currentTarget.blur();
            else if (event.key === "Escape") setTyped(null);
            // The page's own keys, such as F7, are the page's here too.
            else return;
            event.stopPropagation();
          }}
        />
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
          className="seed-chance"
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
