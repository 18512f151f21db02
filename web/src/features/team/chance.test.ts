import { describe, expect, it } from "vitest";

import { percentOf, rateOf } from "./Chance";

describe("how likely robots fail by chance", () => {
  it("is typed in percent", () => {
    expect(["0", "5", " 12.5 ", "2,5", "100", "0.001"].map(rateOf)).toEqual([0, 0.05, 0.125, 0.025, 1, 0.00001]);
  });

  it("is nothing else than a number from 0 to 100", () => {
    expect(["", " ", "-1", "100.1", "much", "1e9", "NaN", "Infinity"].map(rateOf)).toEqual(Array(8).fill(null));
  });

  it("is shown as it was typed", () => {
    for (const percent of ["0", "5", "12.5", "33.333", "100", "0.1", "0.7", "29"]) {
      expect(percentOf(rateOf(percent) ?? NaN)).toBe(percent);
    }
  });
});
