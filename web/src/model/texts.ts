/** Words from XML in the reader's language. The page's language is set once, from outside. */
import type { Texts } from "./types";

let current = "";

/** From now on `text` prefers this language ("" = English, the default of the files). */
export function setLanguage(tag: string): void {
  current = tag;
}

/** The text in the reader's language ("fr-CA" falls back on "fr"), else the default one, else `fallback`. */
export function text(texts: Texts, fallback = "", language = current): string {
  return texts[language] || texts[language.split("-")[0] ?? ""] || texts[""] || texts["en"] || fallback;
}
