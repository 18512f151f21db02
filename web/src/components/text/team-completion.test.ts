import { beforeAll, describe, expect, it } from "vitest";

import { moreWords } from "../../i18n/words";
import { TEAM_ROBOT } from "../../model/team-robot";
import type { Catalogue, Constructor, Method, Mission, Robot } from "../../model/types";
import { complete, standingAt } from "./completion";
import { teamNames } from "./team-names";
import { placeAtEnd } from "./completion-place";

beforeAll(moreWords);

const method = (name: string, kind: Method["kind"]): Method => ({
  ...{ name, kind, label: {}, help: {}, icon: "", phrase: {}, completes_later: false, stop: null, parameters: [] },
});

const robotOf = (name: string): Robot => ({
  ...{ name, label: {}, help: {}, tick_ms: 20, wait_unit_ms: 100 },
  objects: [
    {
      ...{ name: "Cargo", category: "sensor", look: "", hand: "", icon: "", label: {}, help: {} },
      ...{ type: "integer", min: 0, max: 0, initial: 0, shared: false },
      methods: [method("Drop", "procedure"), method("IsPressed", "test")],
    },
  ],
});
const team = robotOf(TEAM_ROBOT);

const construct = (
  name: string,
  code: string,
  level: Constructor["level"],
  role: Constructor["role"],
): Constructor => ({
  ...{ name, group: "", icon: "", colour: "loop", label: {}, help: {}, role, adds: null, code, slots: [] },
  ...(level === undefined ? {} : { level }),
});

const catalogue: Catalogue = {
  groups: [
    {
      ...{ name: "g", colour: "team", label: {} },
      constructors: [
        construct("While", "*[{condition}]({body})", "agent", "instruction"),
        construct("Together", "SeqOfPar {members} ({body})", "group", "instruction"),
        construct("And", "{left} & {right}", "agent", "condition"),
        construct("Any of", "any {members} ({condition})", "group", "condition"),
      ],
    },
  ],
  robots: [robotOf("carrier"), robotOf("loader"), team],
  problems: [],
};

const program = (name: string, robot: string, level: "agent" | "group" | "social") => ({
  ...{ name, robot, level, vertices: [], arcs: [] },
});
const mission: Mission = {
  ...{ version: 1, goals: [], world: "" },
  programs: [
    program("day", TEAM_ROBOT, "social"),
    program("haul", TEAM_ROBOT, "group"),
    program("big drive", "carrier", "agent"),
  ],
  agents: [
    { name: "loader-1", program: "day", start: "", robot: "loader" },
    { name: "carriers", program: "day", start: "", robot: "carrier" },
  ],
  roles: [{ name: "carriers", robot: "carrier", least: 2, most: 5 }],
  groups: [{ name: "big movers", members: ["carriers", "loader-1"], failure: "drop" }],
  works: [],
};
const names = teamNames(mission, catalogue.robots, "day");

const offered = (before: string, robot: Robot = team, explicit = true) =>
  complete(before, robot, catalogue, explicit, names)?.options.map((one) => one.label) ?? null;

const INSTRUCTIONS = ["Cargo", "While", "SeqOfPar members (body)"];
const CONDITIONS = ["Cargo", "And", "any members (condition)"];
const GROUPS = ["carriers", '"big movers"'];
const MEMBERS = [...GROUPS, "loader-1"];
const DECLARATIONS = ["role", "group", "work"];

describe("what may stand at a place of a team's text", () => {
  it.each([
    ["SeqOfPar carriers (", "instruction"],
    ["ParOfSeq carriers (", "instruction"],
    ["SeqOfPar {a, b} (", "instruction"],
    ['SeqOfPar "big movers" (', "instruction"],
    ["SeqOfPar drive-to-A (\n  a.b();\n  ", "instruction"],
    ["SeqOfPar (", "instruction"],
    ["SeqOfPar a ( ParOfSeq b (", "instruction"],
    ["Where a [", "condition"],
    ["Where a [c.d()](", "instruction"],
    ["Where {a, b} [c.d()](e.f(););!(", "instruction"],
    ["[any carriers (", "condition"],
    ["*[all {a, b} (", "condition"],
    ["<most a (b.c() & !(", "condition"],
    ["[!(a.b()) | any c (", "condition"],
    ["[any a (b.c(", "parameter"],
    ["[any a (b.c()) & ", "condition"],
    ["SeqOfPar a ( b.c(", "parameter"],
    ["SeqOfPar a ( WAIT(", "parameter"],
    ["SeqOfPar a ( 3*(", "instruction"],
    ["SeqOfPar ", "members"],
    ["ParOfSeq {", "members"],
    ["ParOfSeq {a, ", "members"],
    ["Where ", "members"],
    ["*(Where ", "members"],
    ["[any ", "members"],
    ["[a.b() & !(most {", "members"],
    ["SeqOfPar a ", "none"],
    ["Where a ", "none"],
    ["PROGRAM ", "program"],
    ["SeqOfPar a ( PROGRAM ", "program"],
    ["PROGRAM drive-to-A ", "instruction"],
    ["MOVE ", "none"],
    ["MOVE 12 ", "group"],
    ["MOVE 1 a ", "none"],
    ["MOVE 1 a -> ", "group"],
    ["MOVE 1 a-> ", "group"],
    ["MOVE 1 a -> b ", "instruction"],
    ["role ", "none"],
    ["role a: ", "robot"],
    ["role a: carrier ", "none"],
    ["role a: carrier 2..3; ", "instruction"],
    ["group a = ", "members"],
    ["group a = {b, ", "members"],
    ["group a = b ", "on"],
    ["group a = {b, c} ", "on"],
    ["group a = b on failure ", "failure"],
    ["group a = b on failure drop ", "none"],
    ["work a = ", "none"],
    ["work a = 12 ", "lease"],
    ["work a = 12 lease ", "none"],
    ["role.Set(", "parameter"],
    ["Where.Stop(", "parameter"],
    ["Where.Stop(); ", "instruction"],
    ["[any.IsOn(", "parameter"],
    ['SeqOfPar "a # [', "members"],
    ["SeqOfPar a ( # (", "none"],
  ])("%j: %s", (before, standing) => {
    expect(standingAt(before, true)).toBe(standing);
  });

  it("is told apart from a procedure that is called like a form", () => {
    expect(standingAt("SeqOfPar (", false)).toBe("parameter");
    expect(standingAt("a.SeqOfPar(", true)).toBe("parameter");
  });

  it("begins where the name begins that is typed", () => {
    expect(placeAtEnd("SeqOfPar carr", true)).toMatchObject({ standing: "members", from: 9 });
    expect(placeAtEnd("PROGRAM drive-", true)).toMatchObject({ standing: "program", from: 8 });
    expect(placeAtEnd('PROGRAM "big d', true)).toMatchObject({ standing: "program", from: 8 });
    expect(placeAtEnd("SeqOfPar {a, b", true)).toMatchObject({ standing: "members", from: 13 });
  });
});

describe("completion of a team's text", () => {
  it.each(["SeqOfPar carriers (", "ParOfSeq {carriers} (", "Where carriers [a.b()](", "Where carriers [a.b()]()!("])(
    "offers constructs and objects inside %j",
    (before) => {
      expect(offered(before)).toEqual(INSTRUCTIONS);
      expect(offered(`${before}\n  Wh`, team, false)).toEqual(INSTRUCTIONS);
    },
  );

  it.each(["[any carriers (", "[all {carriers} (", "<most carriers (", "Where carriers ["])(
    "offers conditions inside %j",
    (before) => {
      expect(offered(before)).toEqual(CONDITIONS);
    },
  );

  it.each([
    "SeqOfPar ",
    "ParOfSeq {",
    "Where ca",
    "[any ",
    "[all {loader-1, ",
    "*[most ",
    "group a = ",
    "group a = {b, ",
  ])("offers who can be in a set behind %j", (before) => {
    expect(offered(before)).toEqual(MEMBERS);
  });

  it("offers groups and roles to move between, programs, robots and the words behind declarations", () => {
    expect(offered("MOVE 1 ")).toEqual(GROUPS);
    expect(offered("MOVE 1 carriers -> ")).toEqual(GROUPS);
    expect(offered("PROGRAM ")).toEqual(["haul", '"big drive"']);
    expect(offered("role a: ")).toEqual(["carrier", "loader"]);
    expect(offered("group a = b ")).toEqual(["on failure"]);
    expect(offered("group a = b on failure ")).toEqual(["drop", "substitute", "abort"]);
    expect(offered("work a = 9 ")).toEqual(["lease"]);
    expect(offered("MOVE ")).toBeNull();
    expect(offered("role ")).toBeNull();
  });

  it("offers no wider program than the one that is typed", () => {
    const inGroup = teamNames(mission, catalogue.robots, "haul");
    expect(inGroup.programs.map(({ name }) => name)).toEqual(["big drive"]);
  });

  it("offers roles and groups that only the text declares", () => {
    const text = 'role porters: carrier 2;\ngroup "all of them" = {porters};\nrole carriers: carrier;\n';
    expect(offered(`${text}SeqOfPar `)).toEqual([...GROUPS, "porters", '"all of them"', "loader-1"]);
  });

  it("offers a group no place in itself", () => {
    expect(offered('group "big movers" = {')).toEqual(["carriers", "loader-1"]);
  });

  it("offers the words of declarations where one may stand, and nowhere else", () => {
    expect(offered("")).toEqual([...DECLARATIONS, ...INSTRUCTIONS]);
    expect(offered("role a: carrier 2..3;\nwork b = 12 lease 60;\ngr", team, false)).toEqual([
      ...DECLARATIONS,
      ...INSTRUCTIONS,
    ]);
    expect(offered("role a: carrier; WAIT(1);\n")).toEqual(INSTRUCTIONS);
    expect(offered("*[a.b()]();\n")).toEqual(INSTRUCTIONS);
    expect(offered("SeqOfPar a (")).toEqual(INSTRUCTIONS);
    expect(offered("role.Set(1); ")).toEqual(INSTRUCTIONS);
  });

  it("offers nothing of a team in the program of one robot", () => {
    const carrier = robotOf("carrier");
    expect(offered("", carrier)).toEqual(["Cargo", "While"]);
    expect(offered("SeqOfPar ", carrier)).toBeNull();
    expect(offered("group a = ", carrier)).toBeNull();
  });

  it("offers names unasked only where one is typed", () => {
    expect(offered("SeqOfPar ", team, false)).toBeNull();
    expect(offered("SeqOfPar c", team, false)).toEqual(MEMBERS);
  });
});
