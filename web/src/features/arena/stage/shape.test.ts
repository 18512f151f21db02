import { describe, expect, it } from "vitest";

import { commonOf, joinLines, lengthOf, type Line, shapeOf } from "./shape";

/** A way of sides and turns to the left, with a point each `step` mm, as a pen leaves it. */
function way(sides: readonly (readonly [mm: number, turn: number])[], step = 7): [number, number][] {
  let [x, y, heading] = [500, 400, 0.3];
  const points: [number, number][] = [[x, y]];
  for (const [mm, turn] of sides) {
    const [fromX, fromY] = [x, y];
    for (let gone = step; gone < mm; gone += step) {
      points.push([fromX + Math.cos(heading) * gone, fromY + Math.sin(heading) * gone]);
    }
    [x, y] = [fromX + Math.cos(heading) * mm, fromY + Math.sin(heading) * mm];
    points.push([x, y]);
    heading += (turn * Math.PI) / 180;
  }
  return points;
}

const polygon = (count: number, mm: number, turn = 360 / count) => way(Array.from({ length: count }, () => [mm, turn]));
const rounded = (numbers: readonly number[] = []) => numbers.map((one) => Math.round(one));

describe("the shape of a line", () => {
  it.each([
    [3, 60],
    [4, 90],
    [6, 120],
    [8, 135],
  ])("of %i equal sides is closed, with corners of %i°", (count, corner) => {
    const shape = shapeOf(polygon(count, 300));
    expect(shape?.closed).toBe(true);
    expect(rounded(shape?.sides)).toEqual(Array.from({ length: count }, () => 300));
    expect(rounded(shape?.corners)).toEqual(Array.from({ length: count }, () => corner));
  });

  it("of a star has its sharp corners", () => {
    expect(rounded(shapeOf(polygon(5, 300, 144))?.corners)).toEqual([36, 36, 36, 36, 36]);
  });

  it("is the same when it is drawn over and over, and when it begins in the middle of a side", () => {
    const twice = shapeOf(way(Array.from({ length: 10 }, () => [250, 90] as const)));
    expect([twice?.closed, rounded(twice?.sides)]).toEqual([true, [250, 250, 250, 250]]);
    const middle = shapeOf(
      way([
        [100, 90],
        [200, 90],
        [200, 90],
        [200, 90],
        [100, 0],
      ]),
    );
    expect([middle?.closed, rounded(middle?.sides)]).toEqual([true, [200, 200, 200, 200]]);
  });

  it("is closed when its ends nearly meet, and open when a side is missing", () => {
    const near = shapeOf(
      way([
        [300, 91],
        [300, 90],
        [300, 90],
        [295, 0],
      ]),
    );
    expect(near?.closed).toBe(true);
    const open = shapeOf(
      way([
        [300, 90],
        [300, 90],
        [300, 0],
      ]),
    );
    expect([open?.closed, open?.sides.length, open?.corners.length]).toEqual([false, 3, 2]);
  });

  it("of a rounded corner is still one corner", () => {
    const bends = Array.from({ length: 4 }, () => [[300, 30] as const, [3, 30] as const, [3, 30] as const]).flat();
    const shape = shapeOf(way(bends, 4));
    expect([shape?.closed, shape?.sides.length]).toEqual([true, 4]);
    expect(rounded(shape?.corners).every((corner) => Math.abs(corner - 90) <= 3)).toBe(true);
  });

  it("of a straight line is one side without corners", () => {
    expect(shapeOf(way([[400, 0]]))).toEqual({ closed: false, sides: [expect.closeTo(400)], corners: [] });
  });

  it("is none of a circle, a dot and nothing", () => {
    expect(shapeOf(polygon(90, 20))).toBeNull();
    expect(shapeOf([[1, 1]])).toBeNull();
    expect(
      shapeOf([
        [1, 1],
        [3, 1],
      ]),
    ).toBeNull();
    expect(shapeOf([])).toBeNull();
  });

  it("does not depend on the step of the simulation", () => {
    for (const step of [1, 5, 20, 90]) {
      const shape = shapeOf(
        way(
          Array.from({ length: 4 }, () => [300, 90] as const),
          step,
        ),
      );
      expect([shape?.closed, rounded(shape?.sides)]).toEqual([true, [300, 300, 300, 300]]);
    }
  });
});

describe("lines", () => {
  const one: Line = [
    [0, 0],
    [10, 0],
  ];

  it("that go on where another ends are one", () => {
    const on: Line = [
      [10, 1],
      [10, 20],
    ];
    const apart: Line = [
      [90, 0],
      [99, 0],
    ];
    expect(joinLines([one, on, [], apart]).map((line) => line.length)).toEqual([3, 2]);
    expect(lengthOf(one)).toBe(10);
  });

  it("of nearly the same length have one, others none", () => {
    expect(commonOf([100, 101, 99], 0.05, 1)).toBe(100);
    expect(commonOf([100, 130], 0.05, 1)).toBeNull();
  });
});
