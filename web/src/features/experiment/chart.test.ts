import { expect, test } from "vitest";

import type { Study, StudyRun } from "../../api/generated";
import { curveOf, nearest, pictureOf, scaleOf, shareOf, stackRuns, ticksOf, variedAxes } from "./chart";

/** A study of these axes, complete, with two seeds, whose one measure is ten times the number of the point. */
function studyOf(...axes: (number | string)[][]): Study {
  const points = axes.reduce<(number | string)[][]>(
    (all, values) => all.flatMap((point) => values.map((value) => [...point, value])),
    [[]],
  );
  return {
    study: "s",
    axes: axes.map((values, at) => ({ address: `a${String(at)}`, values })),
    seeds: 2,
    measures: ["m"],
    seconds: 60,
    version: "1",
    done: 2 * points.length,
    total: 2 * points.length,
    confidence: 0.95,
    command: "",
    points: points.map((values, number) => ({
      number,
      values,
      outcomes: { done: 2 },
      cells: [{ runs: 2, estimate: 10 * number, low: 10 * number - 1, high: 10 * number + 1, method: "" }],
    })),
  };
}

const run = (row: number, value: number | null): StudyRun => ({
  ...{ row, seed: row, outcome: "done", sentence: "", measures: [value] },
});
const FRAME = { left: 0, right: 100, top: 0, bottom: 100 };

test("one axis is a curve, two a map, three several maps, and none the dots of its runs", () => {
  expect([studyOf(), studyOf([1, 2]), studyOf([1, 2], [3, 4]), studyOf([1, 2], [3, 4], [5, 6])].map(pictureOf)).toEqual(
    ["dots", "curve", "map", "maps"],
  );
  expect(pictureOf(studyOf([1, 2], [3, 4], [5, 6], [7, 8]))).toBe("scatter");
});

test("an axis with one value is none, and points that are no grid are scattered", () => {
  const study = studyOf([1], [2, 3]);
  expect([variedAxes(study), pictureOf(study)]).toEqual([[1], "curve"]);
  expect(pictureOf({ ...studyOf([1, 2], [3, 4]), total: 4 })).toBe("scatter");
});

test("a curve has its means in the order of the plan, and each run above its value", () => {
  const curve = curveOf(studyOf([10, 20, 40]), { axis: 0, measure: 0, runs: [run(5, 20), run(0, null)], frame: FRAME });
  const [first, second, third] = curve.means.map(({ x }) => x);
  expect((third ?? 0) - (second ?? 0)).toBeCloseTo(2 * ((second ?? 0) - (first ?? 0)));
  expect(curve.means.every(({ low, y, high }) => low > y && y > high)).toBe(true);
  expect(curve.dots).toMatchObject([{ x: third, y: curve.means[2]?.y, run: { row: 5 } }]);
  expect(curve.xs.map(({ value }) => value)).toEqual([10, 20, 40]);
});

test("words on an axis stand side by side", () => {
  const { means } = curveOf(studyOf(["never", "after"]), { axis: 0, measure: 0, runs: [], frame: FRAME });
  expect(means.map(({ x }) => Math.round(x))).toEqual([5, 95]);
});

test("a scale of one value, or of none, has room around it and round marks", () => {
  expect(scaleOf([7, 7], 0, 100).at(7)).toBeCloseTo(50);
  expect(scaleOf([], 0, 1).at(0.5)).toBe(0.5);
  expect(ticksOf({ low: 0.04, high: 0.31 }, 4)).toEqual([0.1, 0.2, 0.3]);
  expect(ticksOf({ low: -3, high: 12 }, 4)).toEqual([0, 5, 10]);
});

test("runs with one value stand on each other, in the order of their numbers, and those without one are left out", () => {
  const { dots } = stackRuns([run(1, 5), run(0, 5), run(2, null), run(3, 6)], 0, { width: 200, size: 12, edge: 20 });
  expect(dots.map(({ run: { row } }) => row)).toEqual([0, 1, 3]);
  expect(dots[0]?.x).toBe(dots[1]?.x);
  expect(dots[0]?.y).toBeGreaterThan(dots[1]?.y ?? 0);
  expect(dots[2]?.x).toBeGreaterThan(dots[0]?.x ?? 0);
});

test("a press means the nearest dot, and none that is too far", () => {
  const dots = [
    { x: 0, y: 0 },
    { x: 10, y: 0 },
  ];
  expect([nearest(dots, 7, 0, 16), nearest(dots, 40, 0, 16)]).toEqual([dots[1], null]);
});

test("the shade of a field is its share of the span; without a span, or a number, there is none", () => {
  const study = studyOf([1, 2], [1, 2]);
  expect(study.points.map(shareOf(study, 0))).toEqual([0, 1 / 3, 2 / 3, 1]);
  expect(shareOf(studyOf([1]), 0)(studyOf([1]).points[0])).toBe(0);
  expect(shareOf(study, 0)(undefined)).toBeNull();
});
