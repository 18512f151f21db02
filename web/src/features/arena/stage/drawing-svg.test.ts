import { expect, it } from "vitest";

import type { World } from "../../../model/types";
import { drawingSvg } from "./drawing-svg";

const WORLD: World = {
  name: "w",
  width_mm: 200,
  height_mm: 100,
  walls: [{ x1: 0, y1: 0, x2: 200, y2: 0 }],
  floors: [],
  lines: [],
  roads: [],
  docks: [],
  storehouses: [],
  starts: [],
  zones: [{ kind: "warm", x_mm: 50, y_mm: 50, radius_mm: 20, width_mm: 0, height_mm: 0, value: 30, falloff_mm: 0 }],
};

it("writes lines and dots in mm with y down, with the floor under them where that is wanted", () => {
  const line = {
    colour: 1,
    width_mm: 3,
    points: [
      [0, 10],
      [50.04, 10.25],
    ] as [number, number][],
  };
  const dot = { colour: 0, width_mm: 4, points: [[30, 40]] as [number, number][] };
  expect(drawingSvg([line, dot], WORLD, false).split("\n")).toEqual([
    '<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="100mm" viewBox="0 0 200 100" fill="none" stroke-linecap="round" stroke-linejoin="round">',
    '  <path d="M0 90 L50 89.7" stroke="#d3202f" stroke-width="3"/>',
    '  <path d="M30 60 h0" stroke="#1b1f27" stroke-width="4"/>',
    "</svg>",
    "",
  ]);
  const floored = drawingSvg([line], WORLD, true).split("\n");
  expect(floored[1]).toBe('  <rect width="200" height="100" fill="#eceee9"/>');
  expect(floored[2]).toContain('<circle cx="50" cy="50" r="20"');
  expect(floored[3]).toBe('  <path d="M0 100 L200 100" stroke="#5b6472" stroke-width="8"/>');
  expect(floored).toHaveLength(7);
});
