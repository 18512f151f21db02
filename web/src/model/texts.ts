/** Words from XML in the page's language. */
import { languageInUse } from "../i18n/words";
import type { Texts } from "./types";

/** The text in the page's language ("fr-CA" falls back on "fr"), else the default one (English), else `fallback`. */
export function text(texts: Texts, fallback = "", language: string = languageInUse()): string {
  return texts[language] || texts[language.split("-")[0] ?? ""] || texts[""] || texts["en"] || fallback;
}

/** The first sentence of a text, with its full stop, Latin or Urdu; a stop within a word ("1.5 m") ends none. */
export function firstSentence(all: string): string {
  return /^.*?[.۔!?؟](?=\s|$)/su.exec(all)?.[0] ?? all;
}
