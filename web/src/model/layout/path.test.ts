import { describe, expect, it } from "vitest";

import { distanceToLine, headPath, roundedPath } from "./path";

describe("lines", () => {
  const bend = [
    { x: 0, y: 0 },
    { x: 0, y: 40 },
    { x: 40, y: 40 },
  ];

  it("have round corners and stop short of their head", () => {
    expect(roundedPath(bend, true)).toBe("M0 0L0 32Q0 40 8 40L33 40");
    expect(headPath(bend)).toBe("M40 40L31 44L31 36Z");
  });

  it("know how far a point is from them", () => {
    expect(distanceToLine(bend, { x: 10, y: 20 })).toBe(10);
    expect(distanceToLine(bend, { x: 50, y: 40 })).toBe(10);
  });
});
