/** Under what conditions the mission is tried out: how robots hear each other, and what becomes of failed ones on roads. */
import { useState } from "react";

import { t } from "../../i18n/words";
import { setBreakdown, setRadio } from "../../model/commands/changeTrial";
import { useStudio } from "../../model/studio";
import type { Breakdown, Radio } from "../../model/types";
import { Select } from "../../ui/Select";

const MOST_RANGE_MM = 1_000_000;
const MOST_DELAY_MS = 2000;
const LATEST_S = 1_000_000;
const RULES = ["stay", "tow", "pass"] as const;
const STAY: Breakdown = { rule: "stay", after_s: 0 };

interface AmountProps {
  label: string;
  unit: string;
  testId: string;
  /** null: nothing is said, where that is possible. */
  value: number | null;
  least: number;
  most: number;
  optional?: boolean;
  keep: (value: number | null) => void;
}

/** A number with its unit, kept when it is left or by Enter; what is none is taken back. */
function Amount({ label, unit, testId, value, least, most, optional = false, keep }: AmountProps) {
  const shown = value === null ? "" : String(value);
  const [typed, setTyped] = useState<string | null>(null);
  const read = (text: string): number | null | undefined => {
    if (text.trim() === "") return optional ? null : undefined;
    const number = Number(text.trim().replace(",", "."));
    return number >= least && number <= most ? Math.round(number * 1000) / 1000 : undefined;
  };
  const wrong = typed !== null && read(typed) === undefined;
  return (
    <label className="team-amount">
      <span>{label}</span>
      <input
        className="field"
        type="text"
        inputMode="decimal"
        maxLength={12}
        data-testid={testId}
        aria-invalid={wrong}
        placeholder={optional ? t("team.radio-everywhere") : undefined}
        value={typed ?? shown}
        onChange={(event) => setTyped(event.target.value)}
        onBlur={() => {
          const wanted = typed === null ? undefined : read(typed);
          if (wanted !== undefined && wanted !== value) keep(wanted);
          setTyped(null);
        }}
        onKeyDown={(event) => {
          if (event.key === "Enter") event.currentTarget.blur();
          else if (event.key === "Escape") setTyped(null);
          else return;
          event.stopPropagation();
        }}
      />
      <span>{unit}</span>
    </label>
  );
}

function putRadio(radio: Radio | null): void {
  const { mission, execute } = useStudio.getState();
  const command = setRadio(mission, radio);
  if (command !== null) execute(command);
}

function putBreakdown(breakdown: Breakdown): void {
  const { mission, execute } = useStudio.getState();
  const command = setBreakdown(mission, breakdown);
  if (command !== null) execute(command);
}

export function Conditions() {
  const radio = useStudio((studio) => studio.mission.radio ?? null);
  const breakdown = useStudio((studio) => studio.mission.breakdown ?? STAY);
  return (
    <section className="team-part" aria-labelledby="team-conditions" data-testid="conditions">
      <h2 id="team-conditions">{t("team.conditions")}</h2>
      <label className="team-switch">
        <input
          type="checkbox"
          data-testid="radio-on"
          aria-describedby="team-radio-help"
          checked={radio !== null}
          onChange={(event) => putRadio(event.target.checked ? { range_mm: null, delay_ms: 0, loss: 0 } : null)}
        />
        {t("team.radio")}
      </label>
      <p className="team-note" id="team-radio-help">
        {t(radio === null ? "team.radio-off" : "team.radio-help")}
      </p>
      {radio === null ? null : (
        <div className="team-amounts">
          <Amount
            label={t("team.radio-range")}
            unit="mm"
            testId="radio-range"
            value={radio.range_mm ?? null}
            least={1}
            most={MOST_RANGE_MM}
            optional
            keep={(range_mm) => putRadio({ ...radio, range_mm })}
          />
          <Amount
            label={t("team.radio-delay")}
            unit="ms"
            testId="radio-delay"
            value={radio.delay_ms ?? 0}
            least={0}
            most={MOST_DELAY_MS}
            keep={(delay) => putRadio({ ...radio, delay_ms: Math.round(delay ?? 0) })}
          />
          <Amount
            label={t("team.radio-loss")}
            unit="%"
            testId="radio-loss"
            value={radio.loss ?? 0}
            least={0}
            most={100}
            keep={(loss) => putRadio({ ...radio, loss: loss ?? 0 })}
          />
        </div>
      )}
      <div className="team-amounts">
        <label className="team-amount">
          <span>{t("team.breakdown")}</span>
          <Select
            label={t("team.breakdown")}
            testId="breakdown-rule"
            value={breakdown.rule}
            options={RULES.map((rule) => [rule, t(`team.breakdown-${rule}`)])}
            keep={(wanted) => putBreakdown({ ...breakdown, rule: RULES.find((rule) => rule === wanted) ?? "stay" })}
          />
        </label>
        {breakdown.rule === "tow" ? (
          <Amount
            label={t("team.breakdown-after")}
            unit="s"
            testId="breakdown-after"
            value={breakdown.after_s ?? 0}
            least={0}
            most={LATEST_S}
            keep={(after_s) => putBreakdown({ ...breakdown, after_s: after_s ?? 0 })}
          />
        ) : null}
      </div>
    </section>
  );
}
