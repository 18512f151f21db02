/** Changes the mission's title, or the sentence about what happens, in one language. */
import { t } from "../../i18n/words";
import { type Command, commandTo } from "../command";
import type { Mission, Texts } from "../types";

/** Signs that no file can hold; a line break is a space, as the file says it. */
// eslint-disable-next-line no-control-regex -- these are the ones
const UNSAYABLE = /[\u0000-\u0008\u000b\u000c\u000e-\u001f\ufffe\uffff]/g;

export function sayable(words: string): string {
  return words.replace(UNSAYABLE, "").replace(/\s/g, " ");
}

/**
 * `language` is a tag, "" for English. Words that are typed one after another are taken back as one. Null when nothing
 * changes.
 */
export function changeTitle(mission: Mission, what: "label" | "help", language: string, words: string): Command | null {
  const before = mission[what] ?? {};
  const said = sayable(words);
  if ((before[language] ?? "") === said) return null;
  const { [language]: _, ...others } = before;
  const texts: Texts = said === "" ? others : { ...before, [language]: said };
  const { [what]: __, ...rest } = mission;
  const after: Mission = Object.keys(texts).length === 0 ? rest : { ...mission, [what]: texts };
  const label = t(what === "label" ? "command.title" : "command.help");
  return commandTo(label, after, { joins: `${what} ${language}` });
}
