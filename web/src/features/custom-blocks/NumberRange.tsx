/** The least, the greatest and the first value of a number that can be set, and its unit. */
import { t } from "../../i18n/words";
import { inWords, measureOf } from "../../model/meaning";
import type { Meaning } from "../../model/types";
import { whole } from "./openings";

export interface Range {
  min: string;
  max: string;
  first: string;
  unit: string;
}

interface NumberRangeProps {
  of: Range;
  /** What the numbers mean, which is said beside them where it is more than their unit. */
  means?: Meaning | null | undefined;
  what: string;
  onChange: (to: Partial<Range>) => void;
}

export function NumberRange({ of, means, what, onChange }: NumberRangeProps) {
  const measure = means == null || means.scale === "1" ? null : measureOf({ unit: of.unit, meaning: means }, null);
  const field = (name: keyof Range, words: string) => (
    <label className={name === "unit" ? "own-unit" : "own-number"}>
      <span>{words}</span>
      <input
        className="field"
        value={of[name]}
        inputMode={name === "unit" ? "text" : "numeric"}
        autoComplete="off"
        maxLength={name === "unit" ? 12 : 9}
        aria-label={`${what}: ${words}`}
        onChange={(event) => onChange({ [name]: event.target.value })}
      />
    </label>
  );
  return (
    <>
      {field("min", t("own.min"))}
      {field("max", t("own.max"))}
      {field("first", t("own.first"))}
      {field("unit", t("own.unit"))}
      {measure === null ? null : (
        <span className="muted small-text to-end">
          {[of.min, of.max, of.first]
            .map((one) => {
              const number = whole(one);
              return number === null ? "…" : inWords(measure, number);
            })
            .join(" · ")}
        </span>
      )}
    </>
  );
}
