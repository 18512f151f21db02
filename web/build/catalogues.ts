/**
 * Catalogues of translators (gettext, `.po`) as tables for `src/i18n/words.ts`: `import("./fr.po")` gives what each key
 * (msgctxt) is in that language, one form for each plural rule where a sentence counts.
 */
import type { Plugin } from "vite";

type Entry = Readonly<Partial<Record<string, string>>>;
type Forms = Partial<Record<Intl.LDMLPluralRule, string>>;

/** So many counts are tried to find which form each plural rule of a language takes. */
const COUNTS = 200;

export function catalogues(): Plugin {
  return {
    name: "catalogues",
    transform(code, id) {
      return id.endsWith(".po") ? { code: `export default ${JSON.stringify(table(code))};`, map: null } : null;
    },
  };
}

function table(text: string): Record<string, string | Forms> {
  const [header, ...entries] = text.replaceAll("\r\n", "\n").split("\n\n").map(entryOf);
  const language = /^Language: (\w+)$/m.exec(header?.["msgstr"] ?? "")?.[1];
  const rule = /plural=([^;]+);/.exec(header?.["msgstr"] ?? "")?.[1];
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
