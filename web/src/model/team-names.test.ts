import { describe, expect, it } from "vitest";

import { actingIn } from "./team-names";
import { PARTS } from "./testing/parts";
import type { Catalogue, Program } from "./types";

const CATALOGUE = {
  ...PARTS,
  groups: [
    {
      constructors: [
        { name: "Each", slots: [{ name: "who", names: "set" }] },
        { name: "Call", slots: [{ name: "program", names: "program" }] },
      ],
    },
  ],
} as unknown as Catalogue;

function program(name: string, robot: string, ...parts: [string, string, string][]): Program {
  const vertices = parts.map(([element, field, text], index) => ({
    id: `v${String(index)}`,
    element,
    settings: { [field]: text },
    notes: [],
  }));
  return { name, robot, vertices, arcs: [] };
}

describe("who acts at a vertex", () => {
  it("is named in its set, or in those of the program that stands there", () => {
    const programs = [
      program("all", "", ["Each", "who", '{a, "two words"}'], ["Call", "program", "inner"], ["Wait", "who", "a"]),
      program("inner", "", ["Each", "who", "b"], ["Each", "who", "{b, c}"], ["Call", "program", "drive"]),
      program("drive", "carrier", ["Each", "who", "d"]),
    ];
    const found = actingIn(programs, CATALOGUE);
    expect([...(found.get("all") ?? [])]).toEqual([
      ["v0", ["a", "two words"]],
      ["v1", ["b", "c"]],
    ]);
    expect(found.get("drive")?.size).toBe(0);
  });

  it("is found where programs stand in each other", () => {
    const programs = [
      program("one", "", ["Call", "program", "two"], ["Each", "who", "a"]),
      program("two", "", ["Call", "program", "one"], ["Each", "who", "b"]),
    ];
    expect(actingIn(programs, CATALOGUE).get("one")?.get("v0")).toEqual(["b"]);
  });
});
