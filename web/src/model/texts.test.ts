import { expect, it } from "vitest";

import { text } from "./texts";

const WORDS = { "": "While", fr: "Tant que", ur: "جب تک" };

it("takes the reader's language, a dialect's language, then the default, then what it is told", () => {
  expect(text(WORDS, "x", "ur")).toBe("جب تک");
  expect(text(WORDS, "x", "fr-CA")).toBe("Tant que");
  expect(text(WORDS, "x", "de")).toBe("While");
  expect(text({}, "x", "fr")).toBe("x");
  expect(text({ "": "" }, "x", "")).toBe("x");
});
