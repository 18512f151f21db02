/** Words from XML in the page's language. */
import { languageInUse } from "../i18n/words";
import type { Texts } from "./types";

/** The text in the page's language ("fr-CA" falls back on "fr"), else the default one (English), else `fallback`. */
export function text(texts: Texts, fallback = "", language: string = languageInUse()): string {
  return texts[language] || texts[language.split("-")[0] ?? ""] || texts[""] || texts["en"] || fallback;
}
