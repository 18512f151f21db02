/** The least, the greatest and the first value of a number that can be set, and its unit. */
import { t } from "../../i18n/words";

export interface Range {
  min: string;
  max: string;
  first: string;
  unit: string;
}

interface NumberRangeProps {
  of: Range;
  what: string;
  onChange: (to: Partial<Range>) => void;
}

export function NumberRange({ of, what, onChange }: NumberRangeProps) {
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
    </>
  );
}
