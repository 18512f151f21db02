import { afterEach, describe, expect, it } from "vitest";

import { axisTime, clock, decimal, grouped, readNumber, readWhole } from "./numbers";
import { LANGUAGES } from "./languages";
import { type Language, speak } from "./words";

const SPOKEN = Object.keys(LANGUAGES) as Language[];

afterEach(async () => {
  await speak("en");
});

it("uses the reader's decimal sign", async () => {
  expect([clock(42.6), decimal(4.25), decimal(3)]).toEqual(["00:42.6", "4.25", "3"]);
  await speak("fr");
  expect([clock(42.6), decimal(4.25)]).toEqual(["00:42,6", "4,25"]);
});

it("groups thousands with a narrow space and writes the digits of code, in every language", async () => {
  for (const language of SPOKEN) {
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

describe("a number that was typed", () => {
  it("has the digits and the decimal sign of any keyboard", () => {
    const typed = ["2.5", "2,5", "۲٫۵", "٢٫٥", "۲،۵", "۲.۵", " +2.5 ", "02.50"];
    expect(typed.map(readNumber)).toEqual(typed.map(() => 2.5));
    expect(["۹", "٩", "-۹", "−9", ".5", "5.", "0"].map(readNumber)).toEqual([9, 9, -9, -9, 0.5, 5, 0]);
  });

  it("is none with anything else in it", () => {
    const wrong = [
      "",
      " ",
      "-",
      ".",
      "0x10",
      "1e3",
      "NaN",
      "Infinity",
      "1.2.3",
      "1,2,3",
      "--1",
      "5 m",
      "९",
      "1234567890",
    ];
    expect(wrong.map(readNumber)).toEqual(wrong.map(() => null));
  });

  it("is whole or none, where it has to be", () => {
    expect(["۲۰", "-3", "4.0", "۲٫۵", "x"].map(readWhole)).toEqual([20, -3, 4, null, null]);
  });

  it("is read as the page writes it, in every language", async () => {
    for (const language of SPOKEN) {
      await speak(language);
      for (const number of [0, -90, 12.5, -0.001, 999_999_999]) expect(readNumber(decimal(number, 0, 6))).toBe(number);
    }
  });
});
