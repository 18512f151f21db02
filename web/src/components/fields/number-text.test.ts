import { describe, expect, it } from "vitest";

import type { Field } from "../../model/parts";
import { choiceBy } from "./Choices";
import { angleOf, usualAngles } from "./Dial";
import { hzOf, octaveOf } from "./Piano";
import { placeOfTime, timeAt } from "./Slider";
import { isRounded, numberTyped, steppedBy, within } from "./number-text";

const PLAIN: Field = {
  name: "x",
  label: {},
  help: {},
  kind: "integer",
  min: 0,
  max: 100,
  default: "0",
  unit: "%",
  scale: 1,
  meaning: null,
};
const ANGLE: Field = { ...PLAIN, unit: "°", scale: 3.6 };
const TIME: Field = { ...PLAIN, max: 65535, unit: "s", scale: 0.1, meaning: { units: { ur: "سیکنڈ" } } };
const PICTURE: Field = {
  ...PLAIN,
  unit: "",
  max: 1,
  meaning: {
    choices: [
      { value: 0, label: { "": "heart" } },
      { value: 1, label: { "": "small heart" } },
    ],
  },
};

describe("what is typed", () => {
  it("is a whole number with its unit or without", () => {
    expect(["0", " 50 ", "100 %", "007", "50%"].map((typed) => numberTyped(typed, PLAIN))).toEqual([0, 50, 100, 7, 50]);
  });

  it("is a number in the unit, which the scale makes a number of the program", () => {
    expect(["90", "90°", "180 °", "45", "360"].map((typed) => numberTyped(typed, ANGLE))).toEqual([
      25, 25, 50, 13, 100,
    ]);
    expect(["1", "1.0 s", "1,5", ".5s", "2 S"].map((typed) => numberTyped(typed, TIME))).toEqual([10, 10, 15, 5, 20]);
  });

  it("may have digits of Urdu and Arabic, and the name of a choice", () => {
    expect(["۹۰", "٩٠°"].map((typed) => numberTyped(typed, ANGLE))).toEqual([25, 25]);
    expect(["۲٫۵", "۲،۵ s"].map((typed) => numberTyped(typed, TIME))).toEqual([25, 25]);
    expect(["heart", "Small Heart", "1"].map((typed) => numberTyped(typed, PICTURE))).toEqual([0, 1, 1]);
  });

  it("is nothing when it is no number", () => {
    const wrong = ["", "5.5", "1e2", "fast", "0x10", "99999999999999999999", "%", "--1", "1 m"];
    expect(wrong.map((typed) => numberTyped(typed, PLAIN))).toEqual(wrong.map(() => null));
    expect(["1.2.3", "s", "1 m"].map((typed) => numberTyped(typed, TIME))).toEqual([null, null, null]);
  });

  it("out of the range has a nearest, and what is between two steps is rounded", () => {
    expect([400, -1, 25].map((one) => within(one, ANGLE))).toEqual([100, 0, 25]);
    expect(isRounded("45°", 13, ANGLE)).toBe(true);
    expect(isRounded("90°", 25, ANGLE)).toBe(false);
    expect(["۴۵", "۹۰°"].map((typed, at) => isRounded(typed, [13, 25][at] ?? 0, ANGLE))).toEqual([true, false]);
  });
});

describe("keys", () => {
  it("go one step, ten steps and to the ends", () => {
    const keys = ["ArrowUp", "ArrowDown", "PageUp", "PageDown", "Home", "End", "a"];
    expect(keys.map((key) => steppedBy(key, 50, PLAIN, false))).toEqual([51, 49, 60, 40, 0, 100, null]);
    expect(["ArrowRight", "ArrowLeft"].map((key) => steppedBy(key, 50, PLAIN, true))).toEqual([49, 51]);
    expect(steppedBy("PageUp", 95, PLAIN, false)).toBe(100);
  });

  it("walk choices round and round", () => {
    expect(["ArrowRight", "ArrowLeft", "End", "x"].map((key) => choiceBy(key, 0, 3, false))).toEqual([1, 2, 2, null]);
  });
});

describe("fields", () => {
  it("show a time at equal steps for 0, 1, 2, 5 and 10 seconds", () => {
    expect([0, 1, 2, 5, 10, 60].map(placeOfTime)).toEqual([0, 1, 2, 3, 4, 4]);
    expect([0, 0.5, 2.5, 4].map(timeAt)).toEqual([0, 0.5, 3.5, 10]);
  });

  it("turn a dial counter-clockwise from the top, and go on over a full turn", () => {
    expect(angleOf(0, -1, 0)).toBe(0);
    expect(angleOf(-1, 0, 0)).toBe(90);
    expect(angleOf(0, -1, 340)).toBe(360);
    expect(angleOf(-1, 0, 400)).toBe(450);
  });

  it("offer only angles that are whole steps", () => {
    expect(usualAngles(ANGLE)).toEqual([72, 90, 144, 180, 270]);
    expect(usualAngles({ ...ANGLE, scale: 1, max: 180 })).toEqual([45, 72, 90, 135, 144]);
  });

  it("know the notes of a piano", () => {
    expect([hzOf(4, 9), hzOf(4, 0), hzOf(5, 9)]).toEqual([440, 262, 880]);
    expect([440, 262, 880, 0].map(octaveOf)).toEqual([4, 4, 5, 4]);
  });
});
