import { describe, expect, it } from "vitest";

import { changeConstructor, changeVariable, removeVariable, usesOfConstructor } from "./commands/changeOwn";
import { catalogueOf, OWN_GROUP } from "./own-parts";
import { partsOf } from "./parts";
import { PARTS as CATALOGUE } from "./testing/parts";
import type { Constructor, Mission, OwnVariable } from "./types";

const robot = CATALOGUE.robots[0];
const group = CATALOGUE.groups.find(({ constructors }) => constructors.length > 0);

function constructorNamed(name: string): Constructor {
  const some = group?.constructors[0];
  if (some === undefined) throw new Error("no constructor");
  return { ...some, name, group: OWN_GROUP };
}

function variableNamed(name: string): OwnVariable {
  const some = robot?.objects.find((object) => object.category === "variable");
  if (robot === undefined || some === undefined) throw new Error("no variable");
  return { robot: robot.name, variable: { ...some, name } };
}

function missionWith(more: Partial<Mission>): Mission {
  const vertices = ["Start", "Dance", "Trips.Set", "Stop"].map((element) => ({
    id: element.toLowerCase(),
    element,
    settings: {},
    notes: [],
  }));
  const programs = [{ name: "p", robot: robot?.name ?? "", vertices, arcs: [] }];
  return { version: 1, programs, agents: [], goals: [], world: "", ...more };
}

describe("what a mission brings along", () => {
  it("joins the parts of the files", () => {
    const mission = missionWith({ constructors: [constructorNamed("Dance")], variables: [variableNamed("Trips")] });
    const catalogue = catalogueOf(CATALOGUE, mission);
    const parts = partsOf(catalogue, robot?.name ?? "");
    expect(parts.shape("Dance").kind).toBe("constructor");
    expect(parts.shape("Trips.Set").kind).toBe("method");
    expect(catalogue.groups.at(-1)?.name).toBe(OWN_GROUP);
    expect(partsOf(CATALOGUE, robot?.name ?? "").shape("Dance").kind).toBe("unknown");
  });

  it("is nothing where there is none, and wins over a file's", () => {
    expect(catalogueOf(CATALOGUE, missionWith({}))).toBe(CATALOGUE);
    const name = group?.constructors[0]?.name ?? "";
    const catalogue = catalogueOf(CATALOGUE, missionWith({ constructors: [constructorNamed(name)] }));
    const all = catalogue.groups.flatMap((one) => one.constructors).filter((one) => one.name === name);
    expect(all.map((one) => one.group)).toEqual([OWN_GROUP]);
  });

  it("follows a new name into every program", () => {
    const mission = missionWith({ constructors: [constructorNamed("Dance")], variables: [variableNamed("Trips")] });
    const first = changeConstructor(mission, "Dance", constructorNamed("Waltz"));
    const danced = first?.execute(mission) ?? mission;
    const second = changeVariable(danced, robot?.name ?? "", "Trips", variableNamed("Rounds"));
    const after = second?.execute(danced) ?? danced;
    expect(after.programs[0]?.vertices.map((one) => one.element)).toEqual(["Start", "Waltz", "Rounds.Set", "Stop"]);
    expect(usesOfConstructor(after, "Waltz")).toEqual([{ program: "p", vertices: ["dance"] }]);
  });

  it("leaves no empty list behind", () => {
    const mission = missionWith({ variables: [variableNamed("Trips")] });
    const after = removeVariable(mission, robot?.name ?? "", "Trips")?.execute(mission);
    expect(after).toEqual(missionWith({}));
    expect(Object.keys(after ?? {})).not.toContain("variables");
  });
});
