import { expect, it } from "vitest";

import { visualRuns } from "./bidi";

/** The line as the eye meets it from the left: runs from right to left are turned around. */
function seen(line: string, whole: "L" | "R" | null = null): string {
  return visualRuns(line, whole)
    .map(({ text, rightToLeft }) => (rightToLeft ? [...text].reverse().join("") : text))
    .join("");
}

// Capitals of the comments stand for Arabic letters: ا is A, ب is B, ج is C.
it.each([
  ["", null, ""],
  ["speed 50 %", null, "speed 50 %"],
  // "ABC" → "CBA"
  ["ابج", null, "جبا"],
  // "run AB now" keeps its frame, "AB run" turns around as a whole
  ["run اب now", null, "run با now"],
  ["اب run", null, "run با"],
  ["run اب", "R", "با run"],
  // Numbers run to the right everywhere; in an Arabic line they take their place in it.
  ["اب 50 ج", null, "ج 50 با"],
  ["اب ۵۰ ج", null, "ج ۵۰ با"],
  ["x 50 اب", null, "x 50 با"],
  // What stands between two of a kind goes with them, else with the line.
  ["اب، ج.", null, ".ج ،با"],
  ["run اب.", null, "run با."],
  // Brackets are mirrored.
  ["اب (ج)", null, "(ج) با"],
  ["اب (run)", null, "(run) با"],
])("orders %j in a line of %j", (line, whole, expected) => {
  expect(seen(line, whole as "R" | null)).toBe(expected);
});

it("loses and invents no letter", () => {
  const line = "Wait ۳ s — انتظار (ABC) 5 · جب تک؟";
  const sorted = (text: string) => [...text].sort().join("");
  expect(
    sorted(
      visualRuns(line)
        .map(({ text }) => text)
        .join(""),
    ),
  ).toBe(sorted(line));
});
