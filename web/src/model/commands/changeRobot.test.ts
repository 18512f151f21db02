import { describe, expect, it } from "vitest";

import { catalogueOf } from "../own-parts";
import { partsOf } from "../parts";
import { CARRIER } from "../testing/missions";
import { PARTS as CATALOGUE } from "../testing/parts";
import type { Catalogue, Mission, OwnVariable } from "../types";
import { changeRobot } from "./changeRobot";

const carrier = CATALOGUE.robots.find(({ name }) => name === "carrier");
if (carrier === undefined) throw new Error("no carrier");
const lamps = { ...carrier, name: "lamps", objects: carrier.objects.filter(({ name }) => name === "Lamp") };
const ALL: Catalogue = { ...CATALOGUE, robots: [carrier, lamps] };

function variable(name: string): OwnVariable {
  const some = carrier?.objects.find(({ category }) => category === "variable");
  if (some === undefined) throw new Error("no variable");
  return { robot: "carrier", variable: { ...some, name } };
}

const counted = { id: "v30", element: "Trips.Set", settings: {}, notes: [] };
const MISSION: Mission = {
  version: 1,
  programs: [{ ...CARRIER, vertices: [...CARRIER.vertices, counted] }],
  agents: [{ name: "a", program: "carrier", start: "" }],
  goals: [],
  world: "",
  variables: [variable("Trips"), variable("Unused")],
};

describe("another robot for a program", () => {
  const after = changeRobot(MISSION, ALL, "carrier", "lamps")?.execute(MISSION) ?? MISSION;

  it("leaves its vertices, of which those that the robot lacks have no shape", () => {
    const [program] = after.programs;
    expect(program?.robot).toBe("lamps");
    expect(program?.vertices).toBe(MISSION.programs[0]?.vertices);
    expect(after.agents).toBe(MISSION.agents);
    const parts = partsOf(catalogueOf(ALL, after), "lamps");
    expect(parts.shape("Lamp.LightOn").kind).toBe("method");
    expect(parts.shape("Wheel.Advance").kind).toBe("unknown");
  });

  it("takes along the variables of the mission that it uses", () => {
    expect(after.variables?.map((one) => `${one.robot} ${one.variable.name}`)).toEqual([
      "carrier Trips",
      "carrier Unused",
      "lamps Trips",
    ]);
    expect(partsOf(catalogueOf(ALL, after), "lamps").shape("Trips.Set").kind).toBe("method");
    // Back again: they are there already.
    expect(changeRobot(after, catalogueOf(ALL, after), "carrier", "carrier")?.execute(after).variables).toHaveLength(3);
  });

  it("is none where it has that robot, there is no such robot, or it is the team's", () => {
    expect(changeRobot(MISSION, ALL, "carrier", "carrier")).toBeNull();
    expect(changeRobot(MISSION, ALL, "carrier", "boat")).toBeNull();
    expect(changeRobot(MISSION, ALL, "nobody", "lamps")).toBeNull();
    const social = { ...MISSION, programs: MISSION.programs.map((one) => ({ ...one, robot: "" })) };
    expect(changeRobot(social, ALL, "carrier", "lamps")).toBeNull();
  });
});
