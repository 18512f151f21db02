/** The number that typed words mean: "90", "90°", "1,5 s", "heart"; and the number a key leads to. */
import type { KeyboardEvent } from "react";

import { plainDigits, readNumber } from "../../i18n/numbers";
import { inWords, unitOf } from "../../model/meaning";
import type { Field } from "../../model/parts";
import { text } from "../../model/texts";
import type { ControlProps } from "./FieldRow";

/**
 * The number, whole and in steps of the field, but perhaps out of its range; null for what is none. A unit may be there
 * or not. A number without a scale has to be whole.
 */
export function numberTyped(typed: string, field: Field): number | null {
  const plain = typed.trim().toLowerCase();
  const choice = field.meaning?.choices?.find((one) => {
    const label = text(one.label).toLowerCase();
    return label === plain || plainDigits(label) === plainDigits(plain);
  });
  if (choice !== undefined) return choice.value;
  const amount = amountTyped(plain, field);
  if (amount === null) return null;
  const value = amount / field.scale;
  return field.scale === 1 && !Number.isInteger(value) ? null : Math.round(value);
}

/** The number in front of the unit, which may be there or not. */
function amountTyped(typed: string, field: Field): number | null {
  const plain = typed.trim().toLowerCase();
  const unit = [unitOf(field), field.unit].find((one) => one !== "" && plain.endsWith(one.toLowerCase())) ?? "";
  return readNumber(plain.slice(0, plain.length - unit.length));
}

export function within(value: number, { min, max }: Field): number {
  return Math.min(max, Math.max(min, value));
}

/** Whether the number is not quite what was typed: 13 steps of 3.6° for "45". */
export function isRounded(typed: string, value: number, field: Field): boolean {
  const amount = amountTyped(typed, field);
  return amount !== null && Math.abs(value * field.scale - amount) > 1e-6;
}

/** What makes a drawing a slider that keys move. `isMirrored`: the right arrow leads to less. */
export function sliderProps({ field, value, label, set, leave, onFocus }: ControlProps, isMirrored: boolean) {
  return {
    role: "slider",
    tabIndex: 0,
    "aria-label": label,
    "aria-valuemin": field.min,
    "aria-valuemax": field.max,
    "aria-valuenow": value,
    "aria-valuetext": inWords(field, value),
    onFocus,
    onKeyDown: (event: KeyboardEvent) => {
      if (leave(event)) return;
      const next = steppedBy(event.key, value, field, isMirrored);
      if (next === null) return;
      event.preventDefault();
      set(next);
    },
  };
}

/** Where a key leads on a dial, slider or ruler: arrows one step, Page ten, Home and End to the ends; null for others. */
export function steppedBy(key: string, value: number, field: Field, mirrored: boolean): number | null {
  const steps: Record<string, number> = {
    ArrowUp: 1,
    ArrowDown: -1,
    ArrowRight: mirrored ? -1 : 1,
    ArrowLeft: mirrored ? 1 : -1,
    PageUp: 10,
    PageDown: -10,
    Home: -Infinity,
    End: Infinity,
  };
  const by = steps[key];
  return by === undefined ? null : within(value + by, field);
}
