import { afterAll, describe, expect, it } from "vitest";

import { speak } from "../i18n/words";
import { figures, inWords, lightsPath, measureOf, noteOf } from "./meaning";
import { valueWords } from "./words";
import type { Robot, RobotObject } from "./types";

const ROBOT = { wait_unit_ms: 50 } as Robot;
const CHOICES = [
  { value: 0, label: { "": "heart", fr: "cœur" } },
  { value: 1, label: { "": "small heart" } },
];

afterAll(() => speak("en"));

describe("a number in words", () => {
  it("is multiplied by its scale and has its unit", () => {
    expect(inWords(measureOf({ unit: "°", meaning: { scale: "3.6" } }, null), 25)).toBe("90°");
    expect(inWords(measureOf({ unit: "%" }, null), 50)).toBe("50 %");
    expect(inWords(measureOf({ unit: "cm", meaning: { scale: "0.5" } }, null), 15)).toBe("7.5 cm");
    expect(inWords(measureOf({}, null), 7)).toBe("7");
  });

  it("is a time with a tenth, in the robot's unit of waits where that is its scale", () => {
    const wait = { unit: "s", meaning: { scale: "wait-unit", field: "time" as const } };
    expect(inWords(measureOf(wait, null), 10)).toBe("1.0 s");
    expect(inWords(measureOf(wait, ROBOT), 10)).toBe("0.5 s");
    expect(figures(measureOf({ unit: "s", meaning: { scale: "0.001", field: "time" } }, null), 1234)).toBe("1.234");
  });

  it("is the name of a choice, or of a note", () => {
    const picture = measureOf({ meaning: { choices: CHOICES } }, null);
    expect([0, 1, 2].map((value) => inWords(picture, value))).toEqual(["heart", "small heart", "2"]);
    const note = measureOf({ unit: "Hz", meaning: { field: "piano" } }, null);
    expect([440, 880, 262, 441, 0].map((value) => inWords(note, value))).toEqual(["A", "A 5", "C", "441 Hz", "0 Hz"]);
    expect([262, 277, 294, 330, 349, 370, 392, 415, 440, 466, 494].map(noteOf)).toEqual(
      "C C♯ D E F F♯ G G♯ A A♯ B".split(" "),
    );
  });

  it("speaks the reader's language", async () => {
    await speak("fr");
    const time = measureOf({ unit: "s", meaning: { scale: "0.1", field: "time", units: { ur: "سیکنڈ" } } }, null);
    expect(inWords(time, 15)).toBe("1,5 s");
    expect(inWords(measureOf({ meaning: { choices: CHOICES } }, null), 0)).toBe("cœur");
    await speak("ur");
    expect(inWords(time, 15)).toBe("1.5 سیکنڈ");
    await speak("en");
  });
});

describe("what a sensor says", () => {
  const sensor = (more: Partial<RobotObject>) => ({ type: "integer", ...more }) as RobotObject;

  it("is in its words, else true or false, or a number", () => {
    expect(valueWords(sensor({ unit: "cm" }), 77)).toBe("77 cm");
    expect(valueWords(sensor({ type: "boolean", meaning: { choices: CHOICES } }), 1)).toBe("small heart");
    expect(valueWords(sensor({ type: "boolean" }), 1)).toBe("true");
  });
});

it("draws lights as squares of a five by five grid, the dark ones not at all", () => {
  expect(lightsPath("90000 00000 00000 00000 00009")).toBe("M0 0h.8v.8h-.8ZM4 4h.8v.8h-.8Z");
});
