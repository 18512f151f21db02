/** The number that typed words mean: "90", "90°", "1,5 s", "heart"; and the number a key leads to. */
import { plainDigits, readNumber } from "../../i18n/numbers";
import { unitOf } from "../../model/meaning";
import type { Field } from "../../model/parts";
import { text } from "../../model/texts";

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
