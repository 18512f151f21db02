import { describe, expect, it } from "vitest";

import { CARRIER, CARRIER_PARTS, missionOf } from "../testing/missions";
import type { Program } from "../types";
import { moveProgram } from "./changePrograms";
import { shiftParts } from "./shiftParts";

const arcsOf = (program: Program | undefined, ...ids: string[]) =>
  (program?.arcs ?? [])
    .filter((arc) => ids.includes(arc.source))
    .map((arc) => `${arc.source}.${arc.out}>${arc.target}`);

describe("moving by the keyboard", () => {
  const mission = missionOf(CARRIER);
  const shifted = (ids: string[], by: 1 | -1) => shiftParts(CARRIER, CARRIER_PARTS, ids, by);

  it("passes the neighbour, with all that a part holds and its mark", () => {
    const after = shifted(["v9"], -1)?.execute(mission).programs[0];
    expect(arcsOf(after, "v3", "v9", "v7")).toContain("v3.branch.2>v9");
    expect(arcsOf(after, "v9")).toContain("v9.next>v7");
    const back = shiftParts(after ?? CARRIER, CARRIER_PARTS, ["v9"], 1)?.execute(mission).programs[0];
    expect(arcsOf(back, "v3", "v7")).toEqual(expect.arrayContaining(["v3.branch.2>v7", "v7.next>v9"]));
  });

  it("comes out of a body at its end and at its beginning", () => {
    const below = shifted(["v20"], 1)?.execute(mission).programs[0];
    expect(arcsOf(below, "v18", "v20")).toEqual(expect.arrayContaining(["v18.next>v20", "v20.next>v1"]));
    const above = shifted(["v20"], -1)?.execute(mission).programs[0];
    expect(arcsOf(above, "v3", "v20")).toEqual(expect.arrayContaining(["v3.next>v20", "v20.next>v18"]));
  });

  it("stops at the ends of the program", () => {
    expect(shifted(["v1"], -1)).toBeNull();
    expect(shifted(["v1"], 1)).toBeNull();
  });

  it("takes parts of different chains nowhere", () => {
    expect(shifted(["v6", "v20"], 1)).toBeNull();
  });
});

describe("moving a program's tab", () => {
  const mission = missionOf({ ...CARRIER, name: "a" }, { ...CARRIER, name: "b" }, { ...CARRIER, name: "c" });
  const names = (one = mission) => one.programs.map((program) => program.name);

  it("swaps it with its neighbour, and back", () => {
    const command = moveProgram(mission, "a", 1);
    const after = command?.execute(mission);
    expect(names(after)).toEqual(["b", "a", "c"]);
  });

  it("goes nowhere at the ends", () => {
    expect(moveProgram(mission, "a", -1)).toBeNull();
    expect(moveProgram(mission, "c", 1)).toBeNull();
    expect(moveProgram(mission, "nobody", 1)).toBeNull();
  });
});
