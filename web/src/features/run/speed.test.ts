import { describe, expect, it } from "vitest";

import { MAX_POSITION, positionOf, speedAt } from "./speed";

describe("the speed slider", () => {
  it.each([
    [0, 0.1],
    [33, 1],
    [100, 100],
    [MAX_POSITION, 0],
  ])("at %d means %d", (position, speed) => expect(speedAt(position)).toBe(speed));

  it("finds every round speed again", () => {
    for (const speed of [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 0]) expect(speedAt(positionOf(speed))).toBe(speed);
  });
});
