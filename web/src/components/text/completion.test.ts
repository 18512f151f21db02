import { describe, expect, it } from "vitest";

import type { Catalogue, Constructor, Method, Problem, Robot } from "../../model/types";
import { callSnippet, complete, constructSnippet, standingAt } from "./completion";
import { callHelp } from "./help";
import { spansInUnits, stretchesIn } from "../../session/places";

const method = (name: string, kind: Method["kind"], defaults: number[] = []): Method => ({
  ...{ name, kind, label: { "": `label of ${name}` }, help: { "": `help of ${name}` }, icon: "", phrase: {} },
  ...{ completes_later: false, stop: null },
  parameters: defaults.map((one, at) => ({
    ...{ name: `p${String(at)}`, kind: "integer", min: 0, max: 100, default: one, unit: "%" },
    ...{ label: { "": `P${String(at)}` }, help: {} },
  })),
});

const robot: Robot = {
  ...{ name: "r", label: {}, help: {}, tick_ms: 20, wait_unit_ms: 100 },
  objects: [
    {
      ...{ name: "Wheel", category: "actuator", look: "", hand: "", icon: "", label: { "": "Wheels" }, help: {} },
      ...{ type: "integer", min: 0, max: 0, initial: 0, shared: false },
      methods: [method("Advance", "procedure", [50]), method("Stop", "procedure"), method("IsFree", "test")],
    },
  ],
};

const construct = (name: string, code: string, role: Constructor["role"] = "instruction"): Constructor => ({
  ...{ name, group: "", icon: "", colour: "loop", label: {}, help: {}, role, adds: null, code },
  slots: [...code.matchAll(/\{(\w+)\}/g)].map(([, slot = ""]) => ({
    ...{ name: slot, kind: slot === "body" ? "flow" : slot === "count" ? "number" : "condition", label: {} },
    ...{ loop: false, repeat: false, least: 0, min: null, max: null, default: slot === "count" ? "10" : "", unit: "" },
  })),
});

const catalogue: Catalogue = {
  groups: [
    {
      ...{ name: "g", colour: "loop", label: {} },
      constructors: [
        construct("While", "*[{condition}]({body})"),
        construct("Repetition", "{count}*({body})"),
        construct("And", "{left} & {right}", "condition"),
      ],
    },
  ],
  robots: [robot],
  problems: [],
};

const offered = (before: string, explicit = false) =>
  complete(before, robot, catalogue, explicit)?.options.map((one) => one.label) ?? null;

describe("what may stand at a place", () => {
  it.each([
    ["", "instruction"],
    ["*[", "condition"],
    ["*(", "instruction"],
    ["*[a.b()](", "instruction"],
    ["*[(", "condition"],
    ["[a.b() & !(", "condition"],
    ["a.b(", "parameter"],
    ["WAIT(", "parameter"],
    ["//(a.b();, ", "instruction"],
    ["# a [", "none"],
    ["# a [\n", "instruction"],
    ["]]))", "instruction"],
    ["SeqOfPar carriers (", "instruction"],
    ["ParOfSeq {carriers, loader-1} (", "instruction"],
    ["Where carriers [a.b()](", "instruction"],
    ["[any carriers (", "condition"],
  ])("%j: %s", (before, standing) => {
    expect(standingAt(before)).toBe(standing);
  });
});

describe("completion", () => {
  it("offers a robot's methods behind the dot of an object", () => {
    expect(offered("Wheel.")).toEqual(["Advance", "Stop", "IsFree"]);
    expect(complete("Wheel.Ad", robot, catalogue, false)?.from).toBe(6);
    expect(offered("Wing.")).toBeNull();
  });

  it("puts what fits the place first", () => {
    const boost = (before: string) =>
      Object.fromEntries(complete(before, robot, catalogue, false)?.options.map((one) => [one.label, one.boost]) ?? []);
    expect(boost("Wheel.")["Advance"]).toBeGreaterThan(boost("Wheel.")["IsFree"] ?? 0);
    expect(boost("[Wheel.")["IsFree"]).toBeGreaterThan(boost("[Wheel.")["Advance"] ?? 0);
  });

  it("offers objects and constructs for a word, conditions inside a condition", () => {
    expect(offered("Wh")).toEqual(["Wheel", "While", "Repetition"]);
    expect(offered("[Wh")).toEqual(["Wheel", "And"]);
  });

  it("offers constructs for their first marks", () => {
    expect(offered("*[")).toEqual(["*[condition](body)"]);
    expect(offered("Wheel.Stop(); *")).toEqual(["*[condition](body)"]);
  });

  it("offers nothing in a comment, nor unasked after a space", () => {
    expect(offered("# Wh")).toBeNull();
    expect(offered(" ")).toBeNull();
    expect(offered(" ", true)).toContain("Wheel");
  });

  it("writes calls with their defaults and constructs with their slots as fields", () => {
    expect(callSnippet(method("Advance", "procedure", [50, 3]), "instruction")).toBe("Advance(${50}, ${3});${}");
    expect(callSnippet(method("IsFree", "test"), "condition")).toBe("IsFree()${}");
    expect(constructSnippet(construct("While", "*[{condition}]({body})"))).toBe("*[${condition}](\n\t${}\n);");
    expect(constructSnippet(construct("Repetition", "{count}*({body})"))).toBe("${10}*(\n\t${}\n);");
  });
});

describe("help", () => {
  it("tells method and parameters with range and unit", () => {
    expect(callHelp("  Wheel.Advance(50);", 10, robot)).toEqual({
      ...{ from: 2, to: 15, title: "Wheels · label of Advance", help: "help of Advance", parameters: ["P0 · 0…100 %"] },
    });
  });

  it("tells the object on its name, and nothing of comments and strangers", () => {
    expect(callHelp("Wheel.Advance(50);", 2, robot)?.title).toBe("Wheels");
    expect(callHelp("# Wheel.Advance(50);", 4, robot)).toBeNull();
    expect(callHelp("Wing.Flap();", 2, robot)).toBeNull();
  });
});

describe("places", () => {
  const problem = (line: number, column: number, end_line: number, end_column: number): Problem => ({
    ...{ file: "", severity: "error", code: "", message: "", help: "", program: "", vertices: [], arcs: [] },
    ...{ line, column, end_line, end_column },
  });

  it("are offsets of the text, in units", () => {
    expect(stretchesIn("ab\ncd")(problem(2, 1, 2, 3))).toEqual({ from: 3, to: 5 });
    expect(stretchesIn("💥b")(problem(1, 2, 1, 3))).toEqual({ from: 2, to: 3 });
    const span = { vertex: "v", start: 1, end: 2, line: 1 };
    expect(spansInUnits([span], "💥b")).toEqual([{ ...span, start: 2, end: 3 }]);
  });

  it.each([
    ["", 1, 1, 0, 0],
    ["ab", 1, 3, 1, 2],
    ["ab", 9, 9, 1, 2],
    ["ab\n", 2, 1, 3, 3],
    ["ab", 1, 1, 0, 1],
  ])("without length take a character where there is one: %j", (text, line, column, from, to) => {
    expect(stretchesIn(text)(problem(line, column, line, column))).toEqual({ from, to });
  });
});
