/** Under what conditions the mission is tried out: how robots hear each other, and what becomes of failed ones on roads. */
import type { ComponentProps } from "react";

import { NumberInput } from "../../components/fields/NumberInput";
import { t } from "../../i18n/words";
import { setBreakdown, setRadio } from "../../model/commands/changeTrial";
import { execute, useStudio } from "../../model/studio";
import type { Breakdown, Radio } from "../../model/types";
import { Checkbox } from "../../ui/Checkbox";
import { Row } from "../../ui/Row";
import { Select } from "../../ui/Select";

const MOST_RANGE_MM = 1_000_000;
const MOST_DELAY_MS = 2000;
const LATEST_S = 1_000_000;
const RULES = ["stay", "tow", "pass"] as const;
const STAY: Breakdown = { rule: "stay", after_s: 0 };

type AmountProps = ComponentProps<typeof NumberInput> & { label: string; unit: string };

/** A number with its unit. */
function Amount({ label, unit, ...number }: AmountProps) {
  return (
    <Row label={label} className="team-amount">
      <NumberInput {...number} />
      <span>{unit}</span>
    </Row>
  );
}

function thousandths(value: number): number {
  return Math.round(value * 1000) / 1000;
}

function putRadio(radio: Radio | null): void {
  execute(setRadio(useStudio.getState().mission, radio));
}

function putBreakdown(breakdown: Breakdown): void {
  execute(setBreakdown(useStudio.getState().mission, breakdown));
}

export function Conditions() {
  const radio = useStudio((studio) => studio.mission.radio ?? null);
  const breakdown = useStudio((studio) => studio.mission.breakdown ?? STAY);
  return (
    <section className="team-part surface" aria-labelledby="team-conditions" data-testid="conditions">
      <h2 id="team-conditions">{t("team.conditions")}</h2>
      <Checkbox
        testId="radio-on"
        aria-describedby="team-radio-help"
        checked={radio !== null}
        set={(on) => putRadio(on ? { range_mm: null, delay_ms: 0, loss: 0 } : null)}
      >
        {t("team.radio")}
      </Checkbox>
      <p className="team-note muted" id="team-radio-help">
        {t(radio === null ? "team.radio-off" : "team.radio-help")}
      </p>
      {radio === null ? null : (
        <div className="team-amounts wrap flex">
          <Amount
            label={t("team.radio-range")}
            unit="mm"
            testId="radio-range"
            value={radio.range_mm ?? null}
            min={1}
            max={MOST_RANGE_MM}
            optional
            placeholder={t("team.radio-everywhere")}
            keep={(range) => putRadio({ ...radio, range_mm: range === null ? null : thousandths(range) })}
          />
          <Amount
            label={t("team.radio-delay")}
            unit="ms"
            testId="radio-delay"
            value={radio.delay_ms ?? 0}
            min={0}
            max={MOST_DELAY_MS}
            whole
            keep={(delay_ms) => putRadio({ ...radio, delay_ms })}
          />
          <Amount
            label={t("team.radio-loss")}
            unit="%"
            testId="radio-loss"
            value={radio.loss ?? 0}
            min={0}
            max={100}
            keep={(loss) => putRadio({ ...radio, loss: thousandths(loss) })}
          />
        </div>
      )}
      <div className="team-amounts wrap flex">
        <Row label={t("team.breakdown")} className="team-amount">
          <Select
            label={t("team.breakdown")}
            testId="breakdown-rule"
            value={breakdown.rule}
            options={RULES.map((rule) => [rule, t(`team.breakdown-${rule}`)])}
            keep={(wanted) => putBreakdown({ ...breakdown, rule: RULES.find((rule) => rule === wanted) ?? "stay" })}
          />
        </Row>
        {breakdown.rule === "tow" ? (
          <Amount
            label={t("team.breakdown-after")}
            unit="s"
            testId="breakdown-after"
            value={breakdown.after_s ?? 0}
            min={0}
            max={LATEST_S}
            keep={(after) => putBreakdown({ ...breakdown, after_s: thousandths(after) })}
          />
        ) : null}
      </div>
    </section>
  );
}
