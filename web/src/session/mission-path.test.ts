import { expect, it } from "vitest";

import { asMissionPath } from "./document";

it.each([
  ["walk", "walk.krt"],
  [" walk.krt ", "walk.krt"],
  ["Walk.KRT", "Walk.KRT"],
  ["  ", ""],
])("saving as %j writes %j", (typed, path) => expect(asMissionPath(typed)).toBe(path));
