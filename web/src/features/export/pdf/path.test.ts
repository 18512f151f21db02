import { expect, it } from "vitest";

import { ellipse, pathOperators, rectangle } from "./path";

it.each([
  ["M1 2L3 4z", "1 2 m\n3 4 l\nh"],
  ["m1 2 3 4 5 6", "1 2 m\n4 6 l\n9 12 l"],
  ["M0 0H5v-2.5h-.5", "0 0 m\n5 0 l\n5 -2.5 l\n4.5 -2.5 l"],
  ["M0 0C1 2 3 4 5 6S9 8 7 7", "0 0 m\n1 2 3 4 5 6 c\n7 8 9 8 7 7 c"],
  ["M0 0q3 3 6 0t6 0", "0 0 m\n2 2 4 2 6 0 c\n8 -2 10 -2 12 0 c"],
  ["M1 1zl1 0", "1 1 m\nh\n2 1 l"],
  ["", ""],
  ["M nonsense", ""],
])("turns %s into operators", (d, expected) => {
  expect(pathOperators(d)).toBe(expected);
});

/** The places where the curves of a path end. */
function ends(operators: string): [number, number][] {
  return [...operators.matchAll(/(\S+) (\S+) c$/gm)].map((match) => [Number(match[1]), Number(match[2])]);
}

it("draws arcs through the right places, their flags with or without spaces", () => {
  for (const d of ["M10 0A10 10 0 0 1 -10 0", "M10 0a10 10 0 01-20 0"]) {
    const [top, left] = ends(pathOperators(d));
    expect(top?.[0]).toBeCloseTo(0, 3);
    expect(top?.[1]).toBeCloseTo(10, 3);
    expect(left).toEqual([-10, 0]);
  }
  // The large one of the two arcs between the same ends, against the clock.
  const large = ends(pathOperators("M0 10A10 10 0 1 0 10 0"));
  expect(large).toHaveLength(3);
  expect(large.some(([x]) => x < -0.5)).toBe(false);
});

it("gives an arc that is too small the size it needs, and one without a size a line", () => {
  expect(ends(pathOperators("M0 0A1 1 0 0 1 20 0")).at(-1)).toEqual([20, 0]);
  expect(ends(pathOperators("M0 0A0 5 0 0 1 20 0"))).toEqual([[20, 0]]);
  expect(pathOperators("M5 5A3 3 0 0 1 5 5")).toBe("5 5 m");
});

it("rounds corners no further than they fit", () => {
  expect(rectangle(1, 2, 3, 4)).toBe("1 2 3 4 re");
  expect(ends(rectangle(0, 0, 10, 4, 99))).toHaveLength(4);
  expect(ends(ellipse(0, 0, 5, 3))[1]).toEqual([5, 0]);
});
