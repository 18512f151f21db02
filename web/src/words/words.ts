/**
 * The words of the page in the reader's language.
 *
 * `t(key, holes)` looks a sentence up and fills its {holes}; a sentence that counts has one form per plural rule of its
 * language and is chosen by the hole `count`. A language is a table with the keys of English; what a table lacks is said
 * in English.
 */
import { EN } from "./en";

export type Key = keyof typeof EN;
export type Sentence = string | { one: string; other: string };
type Holes = Readonly<Record<string, string | number>>;

const TABLES: Readonly<Record<string, Partial<Record<Key, Sentence>>>> = { en: EN };

let language = "en";

export function languageInUse(): string {
  return language;
}

/** Takes the first language of the list that there is a table for. */
export function chooseLanguage(wanted: readonly string[]): string {
  const found = wanted.map((tag) => tag.toLowerCase().split("-")[0] ?? "").find((tag) => Object.hasOwn(TABLES, tag));
  language = found ?? "en";
  return language;
}

export function t(key: Key, holes: Holes = {}): string {
  const found: Sentence = TABLES[language]?.[key] ?? EN[key];
  const form = typeof found === "string" ? found : found[pluralForm(Number(holes["count"] ?? 0))];
  return form.replace(/\{(\w+)\}/g, (hole, name: string) => String(holes[name] ?? hole));
}

/** A diagnostic's words begin small, since a terminal prints them after a place; a page begins its sentences large. */
export function sentence(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

function pluralForm(count: number): "one" | "other" {
  return new Intl.PluralRules(language).select(count) === "one" ? "one" : "other";
}
