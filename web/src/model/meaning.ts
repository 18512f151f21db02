/**
 * What a number means, in words: "90°", "1.0 s", "heart". Programs hold the number itself.
 *
 * How words that are typed become a number again is in `components/fields/typed.ts`, which comes with the fields.
 */
import { decimal } from "../i18n/numbers";
import { t } from "../i18n/words";
import { text } from "./texts";
import type { Choice, Meaning, Robot } from "./types";

/** What a number is measured in: `scale` units each. */
export interface Measure {
  unit: string;
  scale: number;
  meaning: Meaning | null;
}

/** A parameter, slot or sensor, as the XML says. */
interface Said {
  unit?: string;
  meaning?: Meaning | null;
}

export function measureOf({ unit = "", meaning = null }: Said, robot: Robot | null | undefined): Measure {
  const scale = meaning?.scale ?? "1";
  return { unit, meaning, scale: scale === "wait-unit" ? (robot?.wait_unit_ms ?? 100) / 1000 : Number(scale) };
}

/** The number of a setting, as programs hold it: digits of code. null for what is none. */
export function storedNumber(setting: string): number | null {
  return /^-?[0-9]{1,9}$/.test(setting.trim()) ? Number(setting) : null;
}

export function unitOf({ unit, meaning }: Measure): string {
  return text({ "": unit, ...meaning?.units });
}

export function choiceOf({ meaning }: Measure, value: number): Choice | undefined {
  return meaning?.choices?.find((one) => one.value === value);
}

/** The number without its unit: "90", "1.0". */
export function figures({ scale, meaning }: Measure, value: number): string {
  return decimal(value * scale, meaning?.field === "time" ? 1 : 0, 4);
}

/** "A", "C 5" for a number of Hz that is a note; "" for any other. The octave in the middle has no number. */
export function noteOf(hz: number): string {
  const at = Math.round(12 * Math.log2(hz / 440)) + 9;
  if (hz < 16 || hz > 8000 || Math.round(440 * 2 ** ((at - 9) / 12)) !== hz) return "";
  const octave = Math.floor(at / 12);
  const name = t("graph.notes").split(" ")[at - 12 * octave] ?? "";
  return octave === 0 ? name : `${name} ${String(octave + 4)}`;
}

export function withUnit(words: string, measure: Measure): string {
  const unit = unitOf(measure);
  return unit === "" || unit === "°" ? words + unit : `${words} ${unit}`;
}

/** The number as people read it. */
export function inWords(measure: Measure, value: number): string {
  const choice = choiceOf(measure, value);
  if (choice !== undefined) return text(choice.label);
  const note = measure.meaning?.field === "piano" ? noteOf(value) : "";
  return note === "" ? withUnit(figures(measure, value), measure) : note;
}

/** `d` of a path: five by five lights in a square of five. */
export function lightsPath(lights: string): string {
  return [...lights.replaceAll(" ", "")]
    .map((digit, at) => (digit === "0" ? "" : `M${String(at % 5)} ${String(Math.floor(at / 5))}h.8v.8h-.8Z`))
    .join("");
}
