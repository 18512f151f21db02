import { expect, test } from "vitest";

import type { Adding } from "../../session/view";
import type { Drawing } from "../../session/drawing";
import type { Shape } from "../../model/parts";
import { candidates } from "./AddPopup";

const shape = (element: string, object: boolean): Shape =>
  ({
    element,
    role: "condition",
    label: {},
    object: object ? { name: element.split(".")[0], label: {} } : null,
    method: object ? { name: element.split(".")[1], label: {} } : null,
    constructor_: object ? null : { name: element, label: {} },
    plugs: element === "While" ? [{ name: "condition", accepts: "condition" }] : [],
  }) as unknown as Shape;

test("in a list of tests, what a robot feels stands before what puts tests together", () => {
  const all = [
    shape("And", false),
    shape("Or", false),
    shape("Captor.LessThan", true),
    shape("Button.IsPressed", true),
  ];
  const drawing = {
    program: { vertices: [{ id: "v1", element: "While" }] },
    parts: { all, shape: (element: string) => shape(element, false) },
  } as unknown as Drawing;
  const adding = { slot: { kind: "slot", vertex: "v1", slot: "condition" } } as unknown as Adding;
  const names = (query: string) => candidates(drawing, adding, query).map(({ element }) => element);
  expect(names("")).toEqual(["Captor.LessThan", "Button.IsPressed", "And", "Or"]);
  // What was typed still counts for more.
  expect(names("and")).toEqual(["And"]);
});
