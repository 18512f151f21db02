import { describe, expect, it } from "vitest";

import { further, type Way } from "./arena";

describe("the way that is told", () => {
  it("takes a point that is further on, and no other", () => {
    const way = further([], 10.4, 20);
    expect(way).toEqual([[10, 20]]);
    expect(further(way, 12, 21)).toBe(way);
    expect(further(way, 40, 20)).toEqual([
      [10, 20],
      [40, 20],
    ]);
  });

  it("stays short however long the run is", () => {
    let way: Way = [];
    for (let at = 0; at < 5000; at++) way = further(way, at * 25, 0);
    expect(way.length).toBeLessThanOrEqual(400);
    expect(way[0]).toEqual([0, 0]);
    expect(way.at(-1)).toEqual([4999 * 25, 0]);
  });
});
