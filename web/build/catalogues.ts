/**
 * Catalogues of translators (gettext, `.po`) as tables for `src/i18n/words.ts`: `import("./fr.po")` gives what each key
 * (msgctxt) is in that language, one form for each plural rule where a sentence counts. `import("./fr.po?later")` gives those
 * of parts that are fetched later, which the first does not hold.
 */
import type { Plugin } from "vite";

type Entry = Readonly<Partial<Record<string, string>>>;
type Forms = Partial<Record<Intl.LDMLPluralRule, string>>;

/** So many counts are tried to find which form each plural rule of a language takes. */
const COUNTS = 200;
/** The English of an entry that is fetched later, as its reference says. */
const LATER = /^#: en-later[a-z-]*\.ts$/m;

export function catalogues(): Plugin {
  return {
    name: "catalogues",
    transform(code, id) {
      const found = /\.po(\?later)?$/.exec(id);
      if (found === null) return null;
      return { code: `export default ${JSON.stringify(table(code, found[1] !== undefined))};`, map: null };
    },
  };
}

function table(text: string, later: boolean): Record<string, string | Forms> {
  const [first = "", ...blocks] = text.replaceAll("\r\n", "\n").split("\n\n");
  const header = entryOf(first);
  const entries = blocks.filter((block) => LATER.test(block) === later).map(entryOf);
  const language = /^Language: (\w+)$/m.exec(header["msgstr"] ?? "")?.[1];
  const rule = /plural=([^;]+);/.exec(header["msgstr"] ?? "")?.[1];
  if (language === undefined || rule === undefined)
    throw new Error("a catalogue begins with Language and Plural-Forms");
  // eslint-disable-next-line @typescript-eslint/no-implied-eval -- C's expression in our own file reads the same in JavaScript
  const form = new Function("n", `return Number(${rule});`) as (count: number) => number;
  const plural = new Intl.PluralRules(language);
  const found: Record<string, string | Forms> = {};
  for (const entry of entries) {
    const key = entry["msgctxt"];
    if (key === undefined) continue;
    const forms: Forms = {};
    for (let count = COUNTS; count >= 0 && "msgid_plural" in entry; count--) {
      forms[plural.select(count)] = entry[`msgstr[${String(form(count))}]`] ?? "";
    }
    found[key] = "msgid_plural" in entry ? forms : (entry["msgstr"] ?? "");
  }
  return found;
}

/** One entry by keyword: msgctxt, msgid, msgid_plural, msgstr, msgstr[0] … */
function entryOf(block: string): Entry {
  const entry: Record<string, string> = {};
  let keyword = "";
  for (const line of block.split("\n")) {
    const [, begins, text] = /^(?:(msg\S+) )?(".*")$/.exec(line) ?? [];
    if (text === undefined) continue;
    keyword = begins ?? keyword;
    entry[keyword] = (entry[keyword] ?? "") + String(JSON.parse(text));
  }
  return entry;
}
