/**
 * A number that is typed: stored by Enter, or when the field is left; stepped with the arrows.
 *
 * Digits are those of any keyboard (`readNumber`). What is no number, or none of the range, is said under the field as long
 * as it stands there; Enter then stores the nearest that can be, as in the fields of a part, and Escape what was there before.
 */
import "./number-input.css";

import { type ChangeEvent, type FocusEvent, type KeyboardEvent, useId, useRef, useState } from "react";

import { decimal, readNumber, readWhole } from "../../i18n/numbers";
import { t } from "../../i18n/words";

interface Shared {
  testId: string;
  id?: string;
  /** Where no `<label>` stands around it. */
  label?: string;
  describedBy?: string;
  className?: string;
  placeholder?: string;
  min: number;
  max: number;
  /** What one arrow key adds. */
  step?: number;
  whole?: boolean;
  disabled?: boolean;
}

/** `stepped`: one of several steps that follow each other. Where the number is optional, nothing typed is null. */
type NumberInputProps = Shared &
  (
    | { optional?: false; value: number; keep: (value: number, stepped: boolean) => void }
    | { optional: true; value: number | null; keep: (value: number | null, stepped: boolean) => void }
  );

/** What stands in the way of a number that was typed, and what Enter makes of it; "" where nothing does. */
export function numberWrong(number: number | null, { min, max, whole }: Pick<Shared, "min" | "max" | "whole">): string {
  const [least, most] = [decimal(min, 0, 6), decimal(max, 0, 6)];
  if (number === null) return t(whole === true ? "inspector.whole" : "fields.number", { min: least, max: most });
  if (number > max) return t("fields.at-most", { most });
  return number < min ? t("fields.at-least", { least }) : "";
}

export function NumberInput(props: NumberInputProps) {
  const { testId, id, label, describedBy, className = "field", placeholder, min, max, step = 1, disabled } = props;
  const { optional = false, value, whole = false } = props;
  const why = useId();
  const [typed, setTyped] = useState<string | null>(null);
  const isStored = useRef(false);
  const shown = value === null ? "" : decimal(value, 0, 6);
  const read = whole ? readWhole : readNumber;
  const empty = optional && typed?.trim() === "";
  const number = typed === null ? value : read(typed);
  const wrong = typed === null || empty ? "" : numberWrong(number, { min, max, whole });

  const put = (wanted: number, stepped: boolean) => {
    const nearest = Math.min(Math.max(wanted, min), max);
    if (nearest !== value) props.keep(nearest, stepped);
  };
  const store = () => {
    if (typed === null) return;
    setTyped(null);
    if (number !== null) put(number, false);
    else if (props.optional === true && empty && value !== null) props.keep(null, false);
  };
  const onKeyDown = (event: KeyboardEvent<HTMLInputElement>) => {
    const by = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (event.key === "Enter") {
      store();
      // Keys of the page, such as undo, are the page's again; what was typed is stored once.
      isStored.current = true;
      event.currentTarget.blur();
      isStored.current = false;
    } else if (event.key === "Escape") {
      // Where nothing was typed, it closes what stands around the field.
      if (typed === null) return;
      setTyped(null);
    } else if (by !== undefined) {
      event.preventDefault();
      setTyped(null);
      put((number ?? value ?? min) + by * (event.shiftKey ? 10 : 1) * step, true);
    } else {
      // Keys of the page act on what was typed: F5 runs with it, Ctrl+S saves it.
      if (/^F\d/.test(event.key) || (event.ctrlKey && event.key === "s")) store();
      return;
    }
    event.stopPropagation();
  };
  return (
    <span className="slim block relative">
      <input
        type="text"
        inputMode={whole ? "numeric" : "decimal"}
        dir="ltr"
        autoComplete="off"
        maxLength={20}
        aria-label={label}
        aria-invalid={wrong !== ""}
        aria-describedby={wrong === "" ? describedBy : why}
        data-testid={testId}
        value={typed ?? shown}
        {...{ id, className, placeholder, disabled, onKeyDown }}
        onFocus={(event: FocusEvent<HTMLInputElement>) => event.target.select()}
        onChange={(event: ChangeEvent<HTMLInputElement>) => setTyped(event.target.value)}
        onBlur={() => isStored.current || store()}
      />
      {wrong === "" ? null : (
        <small className="number-why small-text" id={why} role="alert">
          {wrong}
        </small>
      )}
    </span>
  );
}
