/**
 * Numbers and times as the page writes them, digits of code (0–9) in every language and the reader's decimal sign; and the
 * one way in which it reads a number that a person types. `eslint.config.js` keeps others out.
 */
import { languageInUse } from "./words";

/** Times of a run in words: "00:42.6". */
export function clock(seconds: number): string {
  const tenths = Math.floor(Math.max(seconds, 0) * 10 + 1e-6);
  const minutes = Math.floor(tenths / 600);
  const rest = tenths % 600;
  return `${two(minutes)}:${two(Math.floor(rest / 10))}${decimalSign()}${String(rest % 10)}`;
}

/** A mark on the time axis: "0:50", "12:00". */
export function axisTime(seconds: number): string {
  return `${String(Math.floor(seconds / 60))}:${two(Math.round(seconds % 60))}`;
}

/**
 * 2130 → "2 130", with a narrow space: the same in every language, and never taken for a decimal sign. No line breaks at it,
 * and its groups keep their order among letters that run from right to left, as after other spaces they would not.
 */
export function grouped(number: number): string {
  return format({ maximumFractionDigits: 0 })
    .formatToParts(number)
    .map((part) => (part.type === "group" ? "\u202f" : part.value))
    .join("");
}

/** 4.25 → "4.25", in French "4,25"; `least` to `most` digits behind the sign. */
export function decimal(number: number, least = 0, most = 2): string {
  return format({ minimumFractionDigits: least, maximumFractionDigits: most, useGrouping: false }).format(number);
}

/** Digits that Urdu and Arabic keyboards type. */
const OTHER_DIGITS = /[٠-٩۰-۹]/g;
/** Marks of direction, which `Intl` writes beside a minus in Urdu, and which come along with what is copied. */
const DIRECTION = /[\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]/g;
const NUMBER = /^[-+]?(?:[0-9]{1,9}(?:\.[0-9]{0,6})?|\.[0-9]{1,6})$/;

/** The words with digits of Urdu and Arabic as 0–9. */
export function plainDigits(typed: string): string {
  return typed.replace(OTHER_DIGITS, (digit) => String((digit.codePointAt(0) ?? 0) & 15));
}

/**
 * The number that was typed, in digits of English, Urdu or Arabic: up to nine of them, and six behind a point, a comma, `،`
 * or `٫`. null for anything else, such as "", "0x10" and "1e3".
 */
export function readNumber(typed: string): number | null {
  const plain = plainDigits(typed).replace(DIRECTION, "").trim().replace("−", "-").replace(/[,،٫]/, ".");
  return NUMBER.test(plain) ? Number(plain) : null;
}

/** The whole number that was typed; null for anything else. */
export function readWhole(typed: string): number | null {
  const number = readNumber(typed);
  return Number.isInteger(number) ? number : null;
}

const made = new Map<string, Intl.NumberFormat>();

function format(options: Intl.NumberFormatOptions): Intl.NumberFormat {
  const key = `${languageInUse()} ${JSON.stringify(options)}`;
  let found = made.get(key);
  if (found === undefined) {
    // "always": Polish or Spanish would leave four digits together, and numbers that run should not change their shape.
    found = new Intl.NumberFormat(languageInUse(), { numberingSystem: "latn", useGrouping: "always", ...options });
    made.set(key, found);
  }
  return found;
}

function two(number: number): string {
  return String(number).padStart(2, "0");
}

function decimalSign(): string {
  return (
    format({ maximumFractionDigits: 2 })
      .formatToParts(0.5)
      .find((part) => part.type === "decimal")?.value ?? "."
  );
}
