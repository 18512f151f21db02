import { beforeAll, describe, expect, it } from "vitest";

import { moreWords } from "../../i18n/words";
import { emptyProgram } from "./changePrograms";
import filled from "../testing/filled-roles.json";
import type { Agent, Catalogue, Mission } from "../types";
import { castAgent, playing, whyNotCast } from "./castAgents";
import { addAgent, giveProgram, removeAgent, renameAgent } from "./changeAgents";
import {
  addGroup,
  addRole,
  changeRole,
  changeWork,
  joinGroup,
  leaveGroup,
  removeDeclared,
  renameDeclared,
} from "./changeDeclared";
import { renameProgram } from "./changePrograms";

beforeAll(moreWords);

const runs = (name: string, robot: string): Agent => ({ name, program: "team", start: "", robot });

const MISSION: Mission = {
  version: 1,
  programs: [emptyProgram("team", "", "social"), emptyProgram("own", "carrier")],
  agents: [runs("a", "carrier"), runs("b", "carrier"), runs("c", "carrier"), runs("d", "loader")],
  goals: [],
  world: "",
  roles: [
    { name: "first", robot: "carrier", least: 1, most: 1 },
    { name: "rest", robot: "carrier", least: 1, most: 4 },
    { name: "load", robot: "loader", least: 1, most: 1 },
  ],
  groups: [{ name: "all", members: ["first", "rest", "d"], failure: "drop" }],
  works: [{ name: "Boxes", units: 5 }],
};

const slot = (name: string, names: "set" | "program") => ({
  ...{ name, names, kind: "text" as const, label: {}, loop: false, repeat: false, least: 0, min: null, max: null },
  ...{ default: "", unit: "" },
});
const made = (name: string, slots: ReturnType<typeof slot>[]) => ({
  ...{
    name,
    slots,
    group: "Team",
    icon: "",
    colour: "team" as const,
    label: {},
    help: {},
    role: "instruction" as const,
  },
  ...{ adds: null, code: "", level: "group" as const },
});
const CATALOGUE: Catalogue = {
  groups: [
    {
      name: "Team",
      colour: "team",
      label: {},
      constructors: [made("Block", [slot("members", "set")]), made("Call", [slot("name", "program")])],
    },
  ],
  robots: [],
  problems: [],
};

function after(mission: Mission, command: { execute: (mission: Mission) => Mission } | null): Mission {
  if (command === null) throw new Error("there is nothing to do");
  return command.execute(mission);
}

const roles = (mission: Mission) => Object.fromEntries(playing(mission));

describe("agents in roles", () => {
  it("are cast as a run casts them", () => {
    expect(roles(MISSION)).toEqual({ a: "first", b: "rest", c: "rest", d: "load" });
    expect(roles(after(MISSION, changeRole(MISSION, 1, { least: 3 })))).toMatchObject({ a: "first", c: "rest" });
  });

  it("go where they are put, and nobody else does", () => {
    const swapped = after(MISSION, castAgent(MISSION, 1, "first"));
    expect(roles(swapped)).toEqual({ a: "first", b: "first", c: "rest", d: "load" });
    const out = after(MISSION, castAgent(MISSION, 2, ""));
    expect(roles(out)).toEqual({ a: "first", b: "rest", d: "load" });
    expect(roles(after(out, castAgent(out, 2, "first")))).toEqual({ a: "first", b: "rest", c: "first", d: "load" });
  });

  it("stay where the kind does not fit, and the last one of a role stays", () => {
    expect(castAgent(MISSION, 3, "rest")).toBeNull();
    expect(whyNotCast(MISSION, 3, "rest")).toContain("loader");
    expect(castAgent(MISSION, 0, "")).toBeNull();
    expect(whyNotCast(MISSION, 0, "rest")).toContain("first");
    expect(castAgent(MISSION, 9, "rest")).toBeNull();
  });

  it("keep their kind when they come from a program of their own, and lose it when they go back", () => {
    const own = { ...MISSION, agents: [...MISSION.agents, { name: "e", program: "own", start: "" }] };
    const joined = after(own, castAgent(own, 4, "rest"));
    expect(joined.agents[4]).toEqual({ name: "e", program: "team", start: "", robot: "carrier" });
    expect(after(joined, giveProgram(joined, 4, "own")).agents[4]).toEqual({ name: "e", program: "own", start: "" });
    expect(after(MISSION, addAgent(MISSION, "f", "team", "")).agents[4]?.robot).toBe("loader");
  });

  it("are held by the rule for every small team", () => {
    for (let at = 0; at < 3; at++) {
      for (const to of ["first", "rest", ""]) {
        const command = castAgent(MISSION, at, to);
        if (command === null) continue;
        const found = playing(command.execute(MISSION));
        expect(found.get(MISSION.agents[at]?.name ?? "") ?? "").toBe(to);
      }
    }
  });
});

describe("what a team declares", () => {
  const vertex = (id: string, element: string, settings: Record<string, string>) => ({
    id,
    element,
    settings,
    notes: [],
  });
  const drawn: Mission = {
    ...MISSION,
    programs: [
      {
        ...emptyProgram("team", "", "social"),
        vertices: [
          vertex("v1", "Block", { members: '{first, "d", restless}' }),
          vertex("v2", "Call", { name: "first" }),
          vertex("v3", "Boxes.Take", {}),
        ],
      },
      emptyProgram("first", "carrier"),
    ],
  };
  const settings = (mission: Mission, at: number) => mission.programs[0]?.vertices[at]?.settings;

  it("is renamed wherever programs and groups speak of it, and nothing else is", () => {
    const role = after(drawn, renameDeclared(drawn, CATALOGUE, "first", "head of all"));
    expect(role.roles?.[0]?.name).toBe("head of all");
    expect(role.groups?.[0]?.members).toEqual(["head of all", "rest", "d"]);
    expect(settings(role, 0)).toEqual({ members: '{"head of all", "d", restless}' });
    expect(settings(role, 1)).toEqual({ name: "first" });
    const agent = after(drawn, renameAgent(drawn, 3, "e", CATALOGUE));
    expect(settings(agent, 0)).toEqual({ members: "{first, e, restless}" });
    expect(agent.groups?.[0]?.members).toEqual(["first", "rest", "e"]);
    const program = after(drawn, renameProgram(drawn, "first", "drive", CATALOGUE));
    expect([settings(program, 0), settings(program, 1)]).toEqual([
      { members: '{first, "d", restless}' },
      { name: "drive" },
    ]);
    expect(after(drawn, renameDeclared(drawn, CATALOGUE, "Boxes", "Stones")).programs[0]?.vertices[2]?.element).toBe(
      "Stones.Take",
    );
  });

  it("has names of its own", () => {
    expect(addRole(MISSION, "all", "carrier")).toBeNull();
    expect(addGroup(MISSION, "", "first")).toBeNull();
    expect(renameDeclared(MISSION, CATALOGUE, "first", "rest")).toBeNull();
  });

  it("holds nobody twice and nobody itself, and a group is never empty", () => {
    expect(joinGroup(MISSION, 0, "d")).toBeNull();
    expect(joinGroup(MISSION, 0, "all")).toBeNull();
    const one = after(MISSION, leaveGroup(after(MISSION, leaveGroup(MISSION, 0, "d")), 0, "rest"));
    expect(one.groups?.[0]?.members).toEqual(["first"]);
    expect(leaveGroup(one, 0, "first")).toBeNull();
    const gone = after(MISSION, removeAgent(MISSION, 3));
    expect(gone.groups?.[0]?.members).toEqual(["first", "rest"]);
  });

  it("goes with what is left of nothing", () => {
    const only = {
      ...MISSION,
      groups: [
        { name: "g", members: ["first"], failure: "drop" as const },
        { name: "h", members: ["g"], failure: "drop" as const },
      ],
    };
    expect(after(only, removeDeclared(only, "first")).groups).toEqual([]);
    expect(after(MISSION, removeDeclared(MISSION, "first")).groups?.[0]?.members).toEqual(["rest", "d"]);
    expect(removeDeclared(MISSION, "nobody")).toBeNull();
  });

  it("keeps its numbers in order", () => {
    expect(after(MISSION, changeRole(MISSION, 0, { least: 3 })).roles?.[0]).toMatchObject({ least: 3, most: 3 });
    expect(after(MISSION, changeRole(MISSION, 1, { most: 0 })).roles?.[1]).toMatchObject({ least: 1, most: 1 });
    expect(changeRole(MISSION, 0, { least: 1 })).toBeNull();
    expect(after(MISSION, changeWork(MISSION, 0, { lease: 30 })).works).toEqual([
      { name: "Boxes", units: 5, lease: 30 },
    ]);
    expect(changeWork(MISSION, 0, { lease: null })).toBeNull();
  });
});

it("fills the roles of random teams as the simulator does", () => {
  for (const { roles, agents, playing: expected } of filled) {
    const members = agents.map(({ name, robot }) => runs(name, robot));
    expect(Object.fromEntries(playing({ ...MISSION, roles, agents: members }))).toEqual(expected);
  }
});
