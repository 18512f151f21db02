import { afterEach, describe, expect, it } from "vitest";

import { EN as FIRST_EN } from "./en";
import { LATER_EN } from "./en-later";
import { LANGUAGES } from "./languages";
import {
  bestLanguage,
  type Key,
  languageInUse,
  moreWords,
  sentence,
  type Sentence,
  speak,
  t,
  type Table,
} from "./words";

afterEach(async () => {
  await speak("en");
});

it("fills the holes of a sentence", () => {
  expect(t("arena.delivered-of", { done: 7, total: 12 })).toBe("7 of 12 delivered.");
});

it("leaves a hole that nothing fills as it is", () => {
  expect(t("edit.undo-what")).toBe("Undo: {what}");
});

it("counts one and many", () => {
  expect(t("problems.count", { count: 1 })).toBe("1 problem");
  expect(t("problems.count", { count: 0 })).toBe("0 problems");
});

it("counts as each language does: in French nothing is one", async () => {
  await speak("fr");
  expect(t("problems.count", { count: 0 })).toBe("0 problème");
  expect(t("problems.count", { count: 2 })).toBe("2 problèmes");
});

it("finds the language of a dialect, and English for a language without a table", () => {
  expect(bestLanguage(["xx-YY", "fr-CA", "en"])).toBe("fr");
  expect(bestLanguage(["UR-pk"])).toBe("ur");
  expect(bestLanguage(["xx"])).toBe("en");
  expect(bestLanguage(["constructor"])).toBe("en");
  expect(languageInUse()).toBe("en");
});

const FIRST = import.meta.glob<Table>("./*.po", { eager: true, import: "default" });
const LATER = import.meta.glob<Table>("./*.po", { eager: true, import: "default", query: "?later" });
const TABLES: [string, Table][] = Object.entries(LANGUAGES)
  .filter(([code]) => code !== "en")
  .map(([code, { name }]) => [name, { ...FIRST[`./${code}.po`], ...LATER[`./${code}.po`] }]);
const EN = { ...FIRST_EN, ...LATER_EN };
const keys = Object.keys(EN) as Key[];

/** Sentences that are the same in another language: names, and words that it shares with English. */
const NAMES: Key[] = [
  "app.name",
  "arena.radio",
  "boards.title",
  "menu.robots",
  "menu.bar",
  "graph.action",
  "graph.condition",
  "graph.zoom",
  "gallery.robot",
  "parts.robot",
  "parts.variables",
  "inspector.note",
  "inspector.branches",
  "view.code",
  "run.max",
  "run.pause",
  "sheet.agent",
  "sheet.robot",
  "help.keys-pause",
  "help.keys-menu",
  "strip.message",
  "strip.collision",
  "file.untitled",
  "code.projection",
  "fields.octave",
  "members.who",
  "world.kind-zone",
  "world.rectangle",
  "inspector.title",
  "learn.tutorial",
  "variable.menu",
  "view.inspector",
  "view.arena",
  "problems.error",
  "arena.title",
  "roster.roles",
  "team.agents",
  "teacher.minutes",
  "tutorial.of",
  "sweep.robot",
  "own.colour-test",
];

function forms(sentence: Sentence): string[] {
  return typeof sentence === "string" ? [sentence] : Object.values(sentence);
}

function holes(sentence: Sentence): string[] {
  return forms(sentence)
    .map((form) => [...form.matchAll(/\{(\w+)\}/g)].map((match) => match[1]).sort())
    .reduce((all, one) => [...new Set([...all, ...one])].sort(), [] as (string | undefined)[]) as string[];
}

it("has the words of what is fetched later once they are asked for, in every language", async () => {
  for (const [file, first] of Object.entries(FIRST)) {
    expect(Object.keys(first).filter((key) => key in (LATER[file] ?? {}))).toEqual([]);
  }
  await moreWords();
  expect(t("roster.roles")).toBe("Roles");
  await speak("fr");
  expect(t("roster.roles")).toBe("Rôles");
});

it("has a catalogue for every language but English, and no other", () => {
  expect(Object.keys(FIRST).map((file) => file.slice(2, -3))).toEqual(Object.keys(LANGUAGES).slice(1));
});

describe.each(TABLES)("%s", (_, table) => {
  it("lacks no sentence of English", () => {
    expect(keys.filter((key) => table[key] === undefined)).toEqual([]);
  });

  it("has the holes that English has", () => {
    const differ = keys.filter((key) => {
      const said = table[key];
      return said !== undefined && holes(said).join() !== holes(EN[key]).join();
    });
    expect(differ).toEqual([]);
  });

  it("leaves nothing in English that is not a name", () => {
    const same = keys.filter(
      (key) =>
        typeof EN[key] === "string" && /[a-z]{3}/.test(EN[key].replace(/\{\w+\}/g, "")) && table[key] === EN[key],
    );
    expect(same.filter((key) => !NAMES.includes(key))).toEqual([]);
  });
});

it("begins a sentence large, but leaves a quoted name as it is", () => {
  expect([sentence("the slot is empty"), sentence("`a-1` is gone"), sentence("")]).toEqual([
    "The slot is empty",
    "`a-1` is gone",
    "",
  ]);
});

it("every sentence is said somewhere, by its key or by one that begins `so.${…}`", () => {
  const sources = import.meta.glob<string>(["../**/*.{ts,tsx}", "!./en*.ts", "!../**/*.test.*"], {
    query: "?raw",
    import: "default",
    eager: true,
  });
  const source = Object.values(sources).join("\n");
  const said = new Set([...source.matchAll(/"([\w.-]+)"/g)].map(([, key]) => key));
  const beginnings = [...source.matchAll(/`([\w.-]+[.-])\$\{/g)].map(([, key = ""]) => key);
  const keys = [...Object.keys(FIRST_EN), ...Object.keys(LATER_EN)];
  expect(keys.length).toBeGreaterThan(1000);
  expect(keys.filter((key) => !said.has(key) && !beginnings.some((one) => key.startsWith(one)))).toEqual([]);
});
