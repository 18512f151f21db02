import { expect, it } from "vitest";

import { chooseLanguage, languageInUse, sentence, t } from "./words";

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

it("falls back to English for a language without a table", () => {
  expect(chooseLanguage(["xx-YY", "en-GB"])).toBe("en");
  expect(chooseLanguage(["xx"])).toBe("en");
  expect(languageInUse()).toBe("en");
});

it("begins a sentence large, but leaves a quoted name as it is", () => {
  expect([sentence("the slot is empty"), sentence("`a-1` is gone"), sentence("")]).toEqual([
    "The slot is empty",
    "`a-1` is gone",
    "",
  ]);
});
