import { describe, expect, it } from "vitest";

import { catalogueOf } from "./own-parts";
import { partsOf } from "./parts";
import { teamKey, teamRobots } from "./team-robot";
import { PARTS } from "./testing/parts";
import type { Catalogue, Mission, Program } from "./types";

const program = (name: string, robot: string): Program => ({ name, robot, vertices: [], arcs: [] });
const BLOCK = {
  ...PARTS.groups.flatMap(({ constructors }) => constructors)[0],
  name: "Together",
  level: "group" as const,
};
const FILES = {
  ...PARTS,
  groups: [...PARTS.groups, { name: "Team", colour: "team", label: {}, constructors: [BLOCK] }],
  work: { ...PARTS.robots[0]?.objects[0], name: "", category: "system" },
} as unknown as Catalogue;

function mission(...programs: Program[]): Mission {
  return { programs, agents: [], goals: [], works: [{ name: "Boxes", units: 3 }] } as unknown as Mission;
}

describe("the robot of a team", () => {
  const one = PARTS.robots[0]?.name ?? "";

  it("is there where a program of a team is", () => {
    expect(teamRobots(FILES, mission(program("a", one)))).toEqual([]);
    expect(catalogueOf(FILES, mission(program("a", one)))).toBe(FILES);
    expect(teamRobots(FILES, mission(program("a", one), program("b", "")))).toHaveLength(1);
  });

  it("has the parts of its robots and its work, and constructors of all levels", () => {
    const parts = partsOf(catalogueOf(FILES, mission(program("a", one), program("b", ""))), "");
    const names = new Set(parts.robot?.objects.map((object) => object.name));
    expect(names).toContain("Boxes");
    for (const object of PARTS.robots[0]?.objects ?? []) expect(names).toContain(object.name);
    expect(parts.shape("Together").kind).toBe("constructor");
  });

  it("is not what a robot is made of", () => {
    const parts = partsOf(catalogueOf(FILES, mission(program("a", one), program("b", ""))), one);
    expect(parts.shape("Together").kind).toBe("unknown");
    expect(parts.shape("Boxes.Take").kind).toBe("unknown");
  });

  it("stays the same while nothing of it changes", () => {
    const [before, after] = [mission(program("b", "")), mission(program("b", ""), program("c", ""))];
    expect(teamKey(before)).toBe(teamKey(after));
    expect(teamKey(before)).not.toBe(teamKey(mission(program("b", ""), program("c", one))));
  });
});
