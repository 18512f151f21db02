/** A slider. One for a time has 0, 1, 2, 5 and 10 seconds at equal steps; longer ones are typed. */
import { type CSSProperties, type KeyboardEvent, useId } from "react";

import { mirrored } from "../../i18n/language";
import { inWords, withUnit } from "../../model/meaning";
import type { Field } from "../../model/parts";
import type { ControlProps } from "./FieldRow";
import { steppedBy, within } from "./number-text";

const MARKS = [0, 1, 2, 5, 10];
/** Places of the handle between two marks. */
const FINE = 100;

/** Where a time stands, in marks; what is longer than the last one is at the end. */
export function placeOfTime(seconds: number): number {
  const at = MARKS.findIndex((mark) => mark > seconds) - 1;
  if (at < 0) return MARKS.length - 1;
  const [low = 0, high = 1] = MARKS.slice(at);
  return at + (seconds - low) / (high - low);
}

/** The time at a place. */
export function timeAt(place: number): number {
  const at = Math.min(Math.floor(place), MARKS.length - 2);
  const [low = 0, high = 1] = MARKS.slice(at);
  return low + (place - at) * (high - low);
}

export function Slider(props: ControlProps) {
  const { field, value, label, set, leave, onFocus } = props;
  const isTime = field.meaning?.field === "time";
  const marks = useId();
  const onKeyDown = (event: KeyboardEvent) => {
    if (leave(event)) return;
    const next = steppedBy(event.key, value, field, mirrored());
    if (next === null) return;
    event.preventDefault();
    set(isTime && event.key === "End" ? numberOfTime(MARKS.length - 1, field) : next);
  };
  const common = {
    type: "range",
    className: "slider grow",
    "aria-label": label,
    "aria-valuetext": inWords(field, value),
    onKeyDown,
    onFocus,
  };
  if (!isTime) {
    const share = field.max > field.min ? (value - field.min) / (field.max - field.min) : 0;
    return (
      <input
        {...common}
        min={field.min}
        max={field.max}
        value={value}
        style={{ "--share": share } as CSSProperties}
        onChange={(event) => set(event.target.valueAsNumber)}
      />
    );
  }
  const place = placeOfTime(value * field.scale);
  return (
    <span className="field-time column">
      <input
        {...common}
        aria-describedby={marks}
        min={0}
        max={(MARKS.length - 1) * FINE}
        value={Math.round(place * FINE)}
        style={{ "--share": place / (MARKS.length - 1) } as CSSProperties}
        onChange={(event) => set(numberOfTime(event.target.valueAsNumber / FINE, field))}
      />
      <span className="field-marks muted flex between nowrap tiny-text" id={marks} aria-hidden="true">
        {MARKS.map((mark) => (
          <span key={mark}>{mark === MARKS.at(-1) ? withUnit(String(mark), field) : mark}</span>
        ))}
      </span>
    </span>
  );
}

function numberOfTime(place: number, field: Field): number {
  return within(Math.round(timeAt(place) / field.scale), field);
}
