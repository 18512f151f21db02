/**
 * How likely robots fail by chance: part of how the next run is tried out, like its seed, and not of the mission.
 *
 * While a run is on it shows that run's and stays.
 */
import { useState } from "react";

import { t } from "../../i18n/words";
import { isLive, useRun } from "../../session/run";

/** Percent as typed, as a probability; null when it is none. */
export function rateOf(typed: string): number | null {
  const percent = Number(typed.trim().replace(",", "."));
  return typed.trim() === "" || !(percent >= 0 && percent <= 100) ? null : Math.round(percent * 1000) / 100_000;
}

/** A probability in percent, without a tail of zeros. */
export function percentOf(rate: number): string {
  return String(Math.round(rate * 100_000) / 1000);
}

export function Chance() {
  const rate = useRun((run) => run.failRate);
  const live = useRun((run) => isLive(run.status));
  const [typed, setTyped] = useState<string | null>(null);
  const wrong = typed !== null && rateOf(typed) === null;
  const keep = () => {
    const wanted = typed === null ? null : rateOf(typed);
    if (wanted !== null) useRun.setState({ failRate: wanted });
    setTyped(null);
  };
  return (
    <div className="team-chance">
      <label>
        {t("team.chance")}
        <input
          className="field"
          type="text"
          inputMode="decimal"
          maxLength={8}
          data-testid="fail-rate"
          aria-describedby="team-chance-help"
          aria-invalid={wrong}
          disabled={live}
          value={typed ?? percentOf(rate)}
          onFocus={(event) => {
            setTyped(percentOf(rate));
            event.target.select();
          }}
          onChange={(event) => setTyped(event.target.value)}
          onBlur={keep}
          onKeyDown={(event) => {
            if (event.key === "Enter") event.currentTarget.blur();
            else if (event.key === "Escape") setTyped(null);
            else return;
            event.stopPropagation();
          }}
        />
        <span aria-hidden="true">%</span>
      </label>
      <p className="team-note" id="team-chance-help" role={wrong ? "alert" : undefined}>
        {t(wrong ? "team.chance-wrong" : "team.chance-help")}
      </p>
    </div>
  );
}
