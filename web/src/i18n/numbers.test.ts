import { afterEach, describe, expect, it } from "vitest";

import { axisTime, clock, decimal, grouped } from "./numbers";
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
    expect(grouped(21304)).toBe("21\u202f304");
  }
});

describe("times", () => {
  it.each([
    [0, "00:00.0"],
    [42.6, "00:42.6"],
    [59.99, "00:59.9"],
    [3661.2, "61:01.2"],
    [-1, "00:00.0"],
  ])("%d s is %s", (seconds, words) => expect(clock(seconds)).toBe(words));

  it("on the axis have no tenths", () => expect([axisTime(0), axisTime(70)]).toEqual(["0:00", "1:10"]));

  it("group the digits of a tick", () => expect([grouped(21), grouped(2130)]).toEqual(["21", "2\u202f1" + "30"]));
});
