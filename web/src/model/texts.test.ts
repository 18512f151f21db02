import { expect, it } from "vitest";

import { firstSentence, text } from "./texts";

const WORDS = { "": "While", fr: "Tant que", ur: "جب تک" };

it("takes the reader's language, a dialect's language, then the default, then what it is told", () => {
  expect(text(WORDS, "x", "ur")).toBe("جب تک");
  expect(text(WORDS, "x", "fr-CA")).toBe("Tant que");
  expect(text(WORDS, "x", "de")).toBe("While");
  expect(text({}, "x", "fr")).toBe("x");
  expect(text({ "": "" }, "x", "")).toBe("x");
});

it("takes the first sentence of a text in each script, all of one that has no end", () => {
  expect(firstSentence("Drives 1.5 m. It has wheels.")).toBe("Drives 1.5 m.");
  expect(firstSentence("چلتا ہے۔ اس میں پہیے ہیں۔")).toBe("چلتا ہے۔");
  expect(firstSentence("Only Start and Stop")).toBe("Only Start and Stop");
  expect(firstSentence("")).toBe("");
});
