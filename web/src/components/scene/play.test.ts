import { expect, test } from "vitest";

import type { RunPreview } from "../../api/generated";
import type { World } from "../../model/types";
import { bestMoment, boxOf, sceneAt } from "./play";

const WORLD: World = {
  name: "open",
  width_mm: 4000,
  height_mm: 3000,
  walls: [],
  floors: [],
  lines: [],
  roads: [],
  docks: [],
  storehouses: [],
  starts: [{ name: "robot-1", x_mm: 1000, y_mm: 1000, heading_rad: 0 }],
};
const NOTHING = { groups: [], robots: [], problems: [] };

function preview(more: Partial<RunPreview> = {}): RunPreview {
  return {
    program: null,
    world: WORLD,
    seconds: 1,
    frames: 3,
    agents: [{ name: "robot-1", program: "p", robot: "mini-robot", number: 1, start: "" }],
    ways: [[1000, 1000, 0, 0, 0, 1200, 1000, 0, 0, 1, 1400, 1100, 1571, 0, 0]],
    shown: [],
    stock: [],
    things: [],
    pens: [],
    marks: [],
    ...more,
  };
}

test("a room is seen around what is driven, a place with more in it as the arena shows it", () => {
  expect(boxOf(WORLD, preview())).toEqual({ left: 800, right: 1600, bottom: 800, top: 1300 });
  const walled = { ...WORLD, walls: [{ x1: 0, y1: 0, x2: 4000, y2: 0 }] };
  expect(boxOf(walled, preview())).toEqual(boxOf(WORLD, preview()));
  const points: [number, number][] = [
    [0, 0],
    [4000, 0],
  ];
  const lined: World = { ...WORLD, lines: [{ colour: "red", width_mm: 20, closed: false, points }] };
  expect(boxOf(lined, preview()).right).toBeGreaterThan(3999);
  // Who never moves has one pose only.
  expect(boxOf(WORLD, preview({ ways: [[1000, 1000, 0, 0, 0]] }))).toEqual({
    left: 800,
    right: 1200,
    bottom: 800,
    top: 1200,
  });
});

test("what displays and storehouses show is what came last before the moment", () => {
  const shown = [
    { frame: 0, agent: 0, part: "Lamp", numbers: [0] },
    { frame: 2, agent: 0, part: "Lamp", numbers: [1] },
    { frame: 0, agent: 7, part: "Lamp", numbers: [1] },
  ];
  const stock = [
    { frame: 0, storehouse: "A", boxes: 3 },
    { frame: 1, storehouse: "A", boxes: 2 },
  ];
  const made = preview({ shown, stock });
  expect(sceneAt(made, WORLD, NOTHING, 0.9).stock).toEqual({ A: 3 });
  expect(sceneAt(made, WORLD, NOTHING, 1).stock).toEqual({ A: 2 });
  expect(sceneAt(made, WORLD, NOTHING, 1).actors.map(({ name, role }) => [name, role])).toEqual([["robot-1", "robot"]]);
});

test("a drawing is shown whole, a drive a good way through", () => {
  expect(bestMoment(preview({ frames: 81, marks: [[1, 0, 2, 0, 0, 0, 3]] }))).toBe(80);
  expect(bestMoment(preview({ frames: 81 }))).toBe(56);
  expect(bestMoment(preview({ frames: 0 }))).toBe(0);
});
