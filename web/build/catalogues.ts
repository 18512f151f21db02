/**
 * Catalogues of translators (gettext, `.po`) as tables for `src/i18n/words.ts`: `import("./fr.po")` gives what each key
 * (msgctxt) is in that language, one form for each plural rule where a sentence counts, and in English what nobody translated
 * yet. `import("./fr.po?later")` gives those of parts that are fetched later, which the first does not hold.
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
  const forms = formsOf(language, form);
  const found: Record<string, string | Forms> = {};
  for (const entry of entries) {
    const key = entry["msgctxt"];
    if (key === undefined) continue;
    const counted = Object.fromEntries(
      forms.map(([rule, at]) => [
        rule,
        (entry[`msgstr[${String(at)}]`] || entry[rule === "one" ? "msgid" : "msgid_plural"]) ?? "",
      ]),
    );
    found[key] = "msgid_plural" in entry ? counted : ((entry["msgstr"] || entry["msgid"]) ?? "");
  }
  return found;
}

/** Which form of a catalogue each plural rule of its language takes. */
function formsOf(language: string, form: (count: number) => number): [Intl.LDMLPluralRule, number][] {
  const plural = new Intl.PluralRules(language);
  const found = new Map<Intl.LDMLPluralRule, number>();
  for (let count = 0; count <= COUNTS; count++) {
    const rule = plural.select(count);
    const before = found.get(rule) ?? form(count);
    if (before !== form(count)) throw new Error(`${language}: Plural-Forms counts otherwise than Intl does`);
    found.set(rule, before);
  }
  return [...found];
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
