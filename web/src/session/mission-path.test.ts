import { expect, it } from "vitest";

import { asMissionPath, freeMissionName } from "./document";

it.each([
  ["walk", "walk.krt"],
  [" walk.krt ", "walk.krt"],
  ["Walk.KRT", "Walk.KRT"],
  ["  ", ""],
])("saving as %j writes %j", (typed, path) => expect(asMissionPath(typed)).toBe(path));

it.each([
  ["walk", [], "walk"],
  ["walk.krt", ["walk.krt"], "walk-2"],
  ["Walk", ["walk.krt", "walk-2.krt"], "Walk-3"],
  ["walk", ["walk-2.krt", "inner/walk.krt"], "walk"],
  ["", [""], ""],
])("a new mission %j beside %j is called %j", (typed, taken, name) => expect(freeMissionName(typed, taken)).toBe(name));
