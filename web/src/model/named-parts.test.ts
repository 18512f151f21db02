import { expect, test } from "vitest";

import { namesPart } from "./named-parts";
import { missionOf } from "./testing/missions";
import { emptyProgram } from "./commands/changePrograms";

const vertex = (element: string, settings: Record<string, string> = {}) => ({
  id: element,
  element,
  settings,
  notes: [],
});
const program = {
  ...emptyProgram("p", "microbit"),
  vertices: [vertex("Start"), vertex("ButtonA.IsPressed"), vertex("Display.Number", { value: "Light.Value()" })],
};

test("a program names the parts of its vertices and of their numbers, and no others", () => {
  const mission = missionOf(program);
  const named = ["ButtonA", "ButtonB", "Button", "Light", "Loudness", "Display"].filter((part) =>
    namesPart(mission, "p", part),
  );
  expect(named).toEqual(["ButtonA", "Light", "Display"]);
  expect(namesPart(mission, "another", "ButtonA")).toBe(false);
});
