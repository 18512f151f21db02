import { describe, expect, it } from "vitest";

import { CARRIER_PARTS as PARTS } from "../../model/testing/missions";
import { wholeNumber } from "./FieldRow";

const [speed] = PARTS.shape("Wheel.Advance").fields;

describe("wholeNumber", () => {
  it("takes whole numbers of the range, both ends included", () => {
    if (speed === undefined) throw new Error("no field");
    expect(["0", " 50 ", "100", "007"].map((typed) => wholeNumber(typed, speed))).toEqual([0, 50, 100, 7]);
  });

  it("refuses everything else", () => {
    if (speed === undefined) throw new Error("no field");
    const wrong = ["", "101", "-1", "5.5", "1e2", "fast", "0x10", "99999999999999999999"];
    expect(wrong.map((typed) => wholeNumber(typed, speed))).toEqual(wrong.map(() => null));
  });
});
