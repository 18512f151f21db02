import { afterEach, expect, it } from "vitest";

import { clock, decimal, grouped } from "./numbers";
import { speak } from "./words";

afterEach(async () => {
  await speak("en");
});

it("uses the reader's decimal sign", async () => {
  expect([clock(42.6), decimal(4.25), decimal(3)]).toEqual(["00:42.6", "4.25", "3"]);
  await speak("fr");
  expect([clock(42.6), decimal(4.25)]).toEqual(["00:42,6", "4,25"]);
});

it("groups thousands with a narrow space and writes the digits of code, in every language", async () => {
  for (const language of ["en", "fr", "ur"] as const) {
    await speak(language);
    expect(grouped(21304)).toBe("21\u2009304");
  }
});
