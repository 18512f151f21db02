import { describe, expect, it } from "vitest";

import { onlyCalls } from "../model/team-names";
import { TEAM_ROBOT } from "../model/team-robot";
import type { Catalogue, Program, Vertex } from "../model/types";
import { standingIn } from "./run";
import type { RunState } from "./run-state";

const CATALOGUE = {
  groups: [{ constructors: [{ name: "Program", slots: [{ name: "program", names: "program" }] }] }],
} as unknown as Catalogue;

function team(name: string, ...called: string[]): Program {
  const vertices = called.map((program, at): Vertex => ({
    id: `v${String(at)}`,
    element: "Program",
    settings: { program },
    notes: [],
  }));
  return { name, robot: TEAM_ROBOT, vertices, arcs: [] };
}

const running = (inner: [number, string, string][]) =>
  ({
    status: "running",
    team: {},
    agents: [{ name: "a", program: "all", active: [[0, "v9"]], inner }],
  }) as unknown as RunState;

describe("where members of a team stand", () => {
  const programs = [team("all", "driving", '"load boxes"'), team("driving", "carry")];
  const calls = onlyCalls(programs, CATALOGUE);

  it("is the vertex of a program that runs by its name, and each vertex that names a program around it", () => {
    const state = running([[0, "carry", "deep"]]);
    expect([...standingIn(state, "carry", calls)]).toEqual([["deep", ["@0"]]]);
    expect([...standingIn(state, "driving", calls)]).toEqual([["v0", ["@0"]]]);
    expect([...standingIn(state, "all", calls).keys()]).toEqual(["v9", "v0"]);
    expect([...standingIn(running([[0, "load boxes", "x"]]), "all", calls).keys()]).toEqual(["v9", "v1"]);
  });

  it("is not guessed where a program is named twice, and ends where programs name each other", () => {
    const twice = onlyCalls([...programs, team("other", "carry")], CATALOGUE);
    expect([...standingIn(running([[0, "carry", "deep"]]), "driving", twice)]).toEqual([]);
    const circle = onlyCalls([team("one", "two"), team("two", "one")], CATALOGUE);
    expect([...standingIn(running([[0, "one", "x"]]), "two", circle).keys()]).toEqual(["v0"]);
  });
});
