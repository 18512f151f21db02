import { expect, test } from "vitest";

import type { Catalogue, Mission } from "../../model/types";
import { suggest } from "./suggest";

const MISSION = {
  version: 1,
  programs: [{ name: "carrier", robot: "carrier", vertices: [], arcs: [] }],
  agents: [
    { name: "carrier-1", program: "carrier", start: "", robot: "" },
    { name: "big one", program: "carrier", start: "", robot: "" },
  ],
  goals: [],
  world: "",
} as unknown as Mission;
const CATALOGUE = {
  groups: [],
  robots: [
    {
      name: "carrier",
      objects: [
        {
          name: "Cargo",
          category: "sensor",
          methods: [
            { name: "IsPressed", kind: "test", parameters: [] },
            { name: "Value", kind: "value", parameters: [] },
          ],
        },
        { name: "Sign", category: "sensor", methods: [{ name: "EqualTo", kind: "test", parameters: [{}] }] },
        { name: "Wheel", category: "actuator", methods: [{ name: "Stop", kind: "procedure", parameters: [] }] },
      ],
    },
  ],
} as unknown as Catalogue;

const texts = (before: string) => suggest(before, MISSION, CATALOGUE).map(({ text }) => text);

test("first whose it is, then the tests of that robot", () => {
  expect(texts("")).toEqual(["any ", "all ", "most "]);
  expect(texts("a")).toEqual(["any ", "all "]);
  expect(texts("any ")).toEqual(["carrier-1 (", '"big one" (', "carrier ("]);
  expect(texts("any car")).toEqual(["carrier-1 (", "carrier ("]);
  expect(texts("any carrier-1")).toEqual(["carrier-1 ("]);
  expect(texts("any carrier (")).toEqual(["Cargo.IsPressed()", "Sign.EqualTo(1)"]);
  expect(texts('any "big one" (Si')).toEqual(["Sign.EqualTo(1)"]);
  expect(texts("any carrier (Cargo.IsPressed()) & ")).toEqual(["any ", "all ", "most "]);
  expect(texts("any carrier (Cargo.IsPressed()) & !(all carrier-1 (Cargo.")).toEqual(["Cargo.IsPressed()"]);
  expect(texts("any carrier (Cargo.IsPressed()")).toEqual([]);
});

test("what was begun is replaced, and odd text is no mistake", () => {
  expect(suggest("any car", MISSION, CATALOGUE)[0]).toEqual({ text: "carrier-1 (", from: 4 });
  for (const odd of ["(((", ")))", "any", "any nobody (", '"', "}{", "any {a, b} (C"]) texts(odd);
  expect(suggest("any carrier (", MISSION, null)).toEqual([]);
});

test("roles, groups and works of a team", () => {
  const team = {
    ...MISSION,
    programs: [{ name: "relay", robot: "", vertices: [], arcs: [] }],
    agents: [{ name: "one", program: "relay", start: "", robot: "carrier" }],
    roles: [{ name: "runner", robot: "carrier", least: 1, most: 1 }],
    groups: [
      { name: "whole", members: ["inner"], failure: "drop" },
      { name: "inner", members: ["runner", "whole"], failure: "drop" },
    ],
    works: [{ name: "Boxes", units: 3 }],
  } as unknown as Mission;
  const work = {
    name: "Work",
    category: "variable",
    methods: [
      { name: "IsEmpty", kind: "test", parameters: [] },
      { name: "Take", kind: "procedure", parameters: [] },
    ],
  };
  const catalogue = { ...CATALOGUE, work } as unknown as Catalogue;
  const said = (before: string) => suggest(before, team, catalogue).map(({ text }) => text);
  expect(said("any ")).toEqual(["one (", "relay (", "runner (", "whole (", "inner ("]);
  for (const name of ["one", "runner", "whole", "inner"])
    expect(said(`any ${name} (`)).toEqual(["Cargo.IsPressed()", "Sign.EqualTo(1)", "Boxes.IsEmpty()"]);
  expect(said("any nobody (")).toEqual([]);
});
