/**
 * The words of the page in the reader's language.
 *
 * `t(key, holes)` looks a sentence up and fills its {holes}; a sentence that counts has one form per plural rule of its
 * language and is chosen by the hole `count`. Each language is a table in a chunk of its own, fetched when it is wanted, with
 * the keys of English: a test sees to it that none lacks one. `language.ts` chooses, remembers and writes the choice on the
 * page; nothing is drawn before there are words.
 */
import type { EN } from "./en";
import type { LATER_EN } from "./en-later";
import { LANGUAGES } from "./languages";

export type Key = keyof typeof EN | keyof typeof LATER_EN;
export type Sentence = string | ({ other: string } & Partial<Record<Intl.LDMLPluralRule, string>>);
export type Table = Readonly<Partial<Record<Key, Sentence>>>;
type Holes = Readonly<Record<string, string | number>>;

export type Language = keyof typeof LANGUAGES;

type Fetch = Partial<Record<string, () => Promise<Table>>>;

const FETCH: Fetch = {
  ...import.meta.glob<Table>("./*.po", { import: "default" }),
  "./en.po": () => import("./en").then((chunk) => chunk.EN),
};

/** Words of parts of the page that are fetched later, and come with them. */
const FETCH_MORE: Fetch = {
  ...import.meta.glob<Table>("./*.po", { import: "default", query: "?later" }),
  "./en.po": () => import("./en-later").then((chunk) => chunk.LATER_EN),
};

/** The table of a language; an empty one where it has none. */
async function fetched(tables: Fetch, wanted: Language): Promise<Table> {
  return (await tables[`./${wanted}.po`]?.()) ?? {};
}

let language: Language = "en";
/** Whether the words of parts that are fetched later are wanted. */
let more = false;
let table: Table | null = null;
let plural = new Intl.PluralRules("en");

export function languageInUse(): Language {
  return language;
}

export function isLanguage(tag: string): tag is Language {
  return Object.hasOwn(LANGUAGES, tag);
}

/** The first language of the list that there is a table for ("fr-CA" is French), else English. */
export function bestLanguage(wanted: readonly string[]): Language {
  return wanted.map((tag) => tag.toLowerCase().split("-")[0] ?? "").find(isLanguage) ?? "en";
}

/** Speaks that language from now on; when its words cannot be fetched, goes on as before. Gives the language in use. */
export async function speak(wanted: Language): Promise<Language> {
  try {
    const [words, others] = await Promise.all([fetched(FETCH, wanted), more ? fetched(FETCH_MORE, wanted) : {}]);
    table = { ...words, ...others };
  } catch (cause) {
    if (table !== null) return language;
    // Nothing can be said yet: better English than nothing.
    if (wanted === "en") throw cause;
    return speak("en");
  }
  language = wanted;
  plural = new Intl.PluralRules(wanted);
  return language;
}

/** Has the words of `en-later.ts` too from now on, in whatever language is spoken. */
export async function moreWords(): Promise<void> {
  if (more) return;
  const spoken = language;
  const words = await fetched(FETCH_MORE, spoken);
  more = true;
  if (language === spoken) table = { ...table, ...words };
  else await speak(language);
}

export function t(key: Key, holes: Holes = {}): string {
  const found: Sentence = table?.[key] ?? key;
  const form = typeof found === "string" ? found : (found[plural.select(Number(holes["count"] ?? 0))] ?? found.other);
  return form.replace(/\{(\w+)\}/g, (hole, name: string) => String(holes[name] ?? hole));
}

/** "a, b and c" in the language of the page. */
export function listed(words: readonly string[]): string {
  return new Intl.ListFormat(languageInUse()).format(words);
}

/** A diagnostic's words begin small, since a terminal prints them after a place; a page begins its sentences large. */
export function sentence(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}
