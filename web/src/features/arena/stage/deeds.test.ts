import { describe, expect, it } from "vitest";

import type { World } from "../../../model/types";
import {
  colourAt,
  colourDeeds,
  lineDeeds,
  returnDeeds,
  trainDeeds,
  wallAhead,
  wallDeeds,
  type RobotPath,
} from "./deeds";

const box = (left: number, bottom: number, right: number, top: number): [number, number][] => [
  [left, bottom],
  [right, bottom],
  [right, top],
  [left, top],
];
const WORLD: World = {
  name: "room",
  width_mm: 2000,
  height_mm: 2000,
  walls: [{ x1: 2000, y1: 0, x2: 2000, y2: 2000 }],
  floors: [
    { colour: "green", points: box(0, 0, 400, 400) },
    { colour: "red", points: box(1500, 0, 1900, 400) },
  ],
  lines: [
    {
      colour: "blue",
      width_mm: 40,
      closed: false,
      points: [
        [0, 1000],
        [2000, 1000],
      ],
    },
  ],
  roads: [],
  docks: [],
  storehouses: [],
  starts: [],
};

/** A way along these corners, with a place each 20 mm and each 10 ticks. */
function way(...corners: [number, number][]): RobotPath {
  const [xs, ys]: [number[], number[]] = [[], []];
  let mm = 0;
  corners.forEach(([x, y], at) => {
    const [x0, y0] = corners[at - 1] ?? [x, y];
    const long = Math.hypot(x - x0, y - y0);
    const count = Math.max(Math.round(long / 20), 1);
    for (let piece = 1; piece <= count; piece++) {
      xs.push(x0 + ((x - x0) * piece) / count);
      ys.push(y0 + ((y - y0) * piece) / count);
    }
    mm += long;
  });
  return { name: "robot-1", length_mm: 100, xs, ys, ticks: xs.map((_, at) => at * 10), mm };
}

describe("colours", () => {
  it("are those of lines over floors", () => {
    expect([colourAt(WORLD, 100, 100), colourAt(WORLD, 1600, 100), colourAt(WORLD, 900, 1010)]).toEqual([
      "green",
      "red",
      "blue",
    ]);
    expect(colourAt(WORLD, 900, 500)).toBeNull();
  });

  it("are found by who ends on one that it did not begin on, as soon as its front is there", () => {
    const [found] = colourDeeds(WORLD, way([1000, 200], [1700, 200]));
    expect(found).toMatchObject({ kind: "found", name: "robot-1", colour: "red" });
    // Its front is 50 mm before its middle: at x = 1460 of 1000, a place each 20 mm.
    expect(found).toHaveProperty("tick", 230);
  });

  it("are left by who ends on none", () => {
    expect(colourDeeds(WORLD, way([200, 200], [900, 200]))).toMatchObject([{ kind: "left", colour: "green" }]);
    expect(colourDeeds(WORLD, way([200, 200], [300, 200]))).toEqual([]);
    expect(colourDeeds(WORLD, way([600, 600], [900, 600]))).toEqual([]);
  });
});

describe("a line", () => {
  it("is followed by who goes along it, not by who crosses it", () => {
    expect(lineDeeds(WORLD, way([100, 1010], [1500, 990]))).toMatchObject([
      { kind: "followed", mm: expect.closeTo(1400, 0) as number },
    ]);
    expect(lineDeeds(WORLD, way([600, 400], [600, 1600]))).toEqual([]);
    expect(lineDeeds(WORLD, way([100, 1000], [300, 1000]))).toEqual([]);
  });
});

describe("who comes back", () => {
  it("has been away and is where it began", () => {
    const square = way([600, 600], [900, 600], [900, 900], [600, 900], [600, 610]);
    expect(returnDeeds([square, way([0, 0], [900, 0])])).toEqual([{ kind: "returned", name: "robot-1", count: 1 }]);
    expect(returnDeeds([way([600, 600], [620, 600], [600, 600])])).toEqual([]);
    expect(returnDeeds([])).toEqual([]);
  });
});

describe("robots in a row", () => {
  it("stay near to the one before them all the way", () => {
    const [first, second] = [way([500, 600], [1700, 600]), way([100, 600], [1300, 600])];
    expect(trainDeeds([first, second])).toMatchObject([
      { kind: "apart", count: 2, least: expect.closeTo(400, 0) as number, most: expect.closeTo(400, 0) as number },
    ]);
    expect(trainDeeds([first, way([100, 1900], [1300, 1900])])).toEqual([]);
    expect(trainDeeds([first])).toEqual([]);
  });
});

describe("a wall", () => {
  const pose = { x_mm: 1800, y_mm: 500, heading_rad: 0, load: 0, flags: 0 };
  it("is as far ahead as there is room before the front", () => {
    expect(wallAhead(WORLD, pose, 100)).toBeCloseTo(150);
    expect(wallAhead(WORLD, { ...pose, heading_rad: Math.PI }, 100)).toBe(Infinity);
    expect(wallAhead({ walls: [] }, pose, 100)).toBe(Infinity);
  });

  it("is what somebody stopped before who drove there and stands near", () => {
    expect(wallDeeds(WORLD, way([1000, 500], [1800, 500]), pose)).toMatchObject([{ kind: "before-wall" }]);
    expect(wallDeeds(WORLD, way([1000, 500], [1800, 500]), { ...pose, x_mm: 1000 })).toEqual([]);
    expect(wallDeeds(WORLD, way([1790, 500], [1800, 500]), pose)).toEqual([]);
  });
});
