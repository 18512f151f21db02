import { expect, it } from "vitest";

import { join } from "./arabic";

function forms(text: string): string {
  return join(text)
    .map(({ code }) => code.toString(16))
    .join(" ");
}

it.each([
  // alone, at the beginning, in the middle, at the end
  ["ب", "fe8f"],
  ["ببب", "fe91 fe92 fe90"],
  // A letter that joins only to what is before it ends the chain.
  ["دبد", "fea9 fe91 feaa"],
  ["رب", "fead fe8f"],
  // Letters of Urdu: heh goal, do-chashmi heh, bari yeh, tteh, nun ghunna, farsi yeh, keheh
  ["ہہہ", "fba8 fba9 fba7"],
  ["بھ", "fe91 fbab"],
  ["ہے", "fba8 fbaf"],
  ["ٹھیک", "fb68 fbad fbff fb8f"],
  ["میں", "fee3 fbff fb9f"],
  // Lam and alef are one form.
  ["لا", "fefb"],
  ["بلا", "fe91 fefc"],
  // A mark joins nothing and parts nothing.
  ["بَب", "fe91 64e fe90"],
  // What has no form of its own comes as letter and mark.
  ["ۂ", "fba6 654"],
  // Spaces part words; other letters stay.
  ["ب ب", "fe8f 20 fe8f"],
  ["aب", "61 fe8f"],
])("joins %s", (text, expected) => {
  expect(forms(text)).toBe(expected);
});

it("remembers what was typed", () => {
  const text = "جب تک لاہور میں ٹھیک ہے";
  expect(
    join(text)
      .map((one) => one.text)
      .join(""),
  ).toBe(text);
});
