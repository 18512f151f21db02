/**
 * The language of the page: chosen in the View menu and remembered, at first the browser's.
 *
 * What is spoken is written on the root element as lang and dir, which turns the whole page for a language that runs
 * from right to left.
 */
import { create } from "zustand";

import { LANGUAGES } from "./languages";
import { bestLanguage, isLanguage, type Language, languageInUse, speak } from "./words";

const KEY = "kitrobot.language";

function remembered(): Language | null {
  try {
    const value = localStorage.getItem(KEY) ?? "";
    return isLanguage(value) ? value : null;
  } catch {
    return null;
  }
}

/** Fetches what else has words of a language; what it gives puts them in place. */
type Preparation = (language: Language) => Promise<() => void>;

const preparations: Preparation[] = [];
/** So long a language waits for what else has its words, in ms: a server that is slow does not hold up the page. */
const WAIT_MS = 1000;

/** What `work` gives, or null once it is late. */
async function orLate<T>(work: Promise<T>): Promise<T | null> {
  let timer = 0;
  const late = new Promise<null>((end) => {
    timer = window.setTimeout(end, WAIT_MS, null);
  });
  return Promise.race([work, late]).finally(() => window.clearTimeout(timer));
}

/** Before the page speaks another language that is fetched, so that it never speaks two. */
export function prepareLanguage(preparation: Preparation): void {
  preparations.push(preparation);
}

interface LanguageState {
  language: Language;
  choose: (language: Language) => Promise<void>;
}

export const useLanguage = create<LanguageState>((set) => ({
  language: languageInUse(),
  choose: async (wanted) => {
    const prepared = Promise.all(preparations.map((prepare) => prepare(wanted)));
    const there = await orLate(prepared);
    const language = await speak(wanted);
    if (language === wanted) {
      try {
        localStorage.setItem(KEY, wanted);
      } catch {
        // A browser without storage keeps the choice until the page is closed.
      }
    }
    write(language);
    set({ language });
    if (language !== wanted) return;
    for (const put of there ?? (await prepared)) put();
  },
}));

function write(language: Language): void {
  document.documentElement.lang = language;
  document.documentElement.dir = LANGUAGES[language].dir;
}

/** Speaks the reader's language before anything is drawn. */
export async function installLanguage(): Promise<void> {
  const language = await speak(remembered() ?? bestLanguage(navigator.languages));
  write(language);
  useLanguage.setState({ language });
}

/** Whether the page runs from right to left. */
export function mirrored(): boolean {
  return LANGUAGES[languageInUse()].dir === "rtl";
}
