import { describe, expect, it } from "vitest";

import { CARRIER, CARRIER_PARTS, missionOf } from "../testing/missions";
import { renameProgram } from "./changePrograms";
import { breakpointAt, removeBreakpoint, setBreakpoint } from "./changeBreakpoints";
import { setFailures } from "./changeTrial";

const mission = missionOf(CARRIER);
const vertex = CARRIER.vertices[1]?.id ?? "";

describe("breakpoints", () => {
  it("are set, changed and taken away", () => {
    const set = setBreakpoint(CARRIER_PARTS, mission, { program: CARRIER.name, vertex });
    const one = set?.execute(mission) ?? mission;
    expect(breakpointAt(one, CARRIER.name, vertex)).toEqual({ program: CARRIER.name, vertex });
    const change = setBreakpoint(CARRIER_PARTS, one, { program: CARRIER.name, vertex, hits: 3, when: "Run.IsTrue()" });
    const two = change?.execute(one) ?? one;
    expect(two.breakpoints).toEqual([{ program: CARRIER.name, vertex, hits: 3, when: "Run.IsTrue()" }]);
    const three = removeBreakpoint(two, CARRIER.name, vertex)?.execute(two);
    expect(three).toEqual(mission);
    expect(Object.keys(three ?? {})).not.toContain("breakpoints");
  });

  it("are named by the plain label of their vertex", () => {
    const set = setBreakpoint(CARRIER_PARTS, mission, { program: CARRIER.name, vertex: "v6" });
    expect(set?.label).toBe("Breakpoint at Lamp LightOn");
  });

  it("stand at vertices only", () => {
    expect(setBreakpoint(CARRIER_PARTS, mission, { program: CARRIER.name, vertex: "nobody" })).toBeNull();
    expect(setBreakpoint(CARRIER_PARTS, mission, { program: "nothing", vertex })).toBeNull();
    expect(removeBreakpoint(mission, CARRIER.name, vertex)).toBeNull();
  });

  it("follow their program to its new name", () => {
    const one = setBreakpoint(CARRIER_PARTS, mission, { program: CARRIER.name, vertex })?.execute(mission) ?? mission;
    const two = renameProgram(one, CARRIER.name, "other")?.execute(one) ?? one;
    expect(two.breakpoints).toEqual([{ program: "other", vertex }]);
  });

  it("of vertices that are gone go with the next change", () => {
    const stale = { ...mission, breakpoints: [{ program: CARRIER.name, vertex: "gone" }] };
    const after = setBreakpoint(CARRIER_PARTS, stale, { program: CARRIER.name, vertex })?.execute(stale);
    expect(after?.breakpoints).toEqual([{ program: CARRIER.name, vertex }]);
  });
});

describe("failures on schedule", () => {
  it("stand in the order of time", () => {
    const after = setFailures(mission, [
      { agent: "b", at_s: 9, kind: "revive" },
      { agent: "a", at_s: 3, kind: "fail" },
    ])?.execute(mission);
    expect(after?.failures?.map((one) => one.at_s)).toEqual([3, 9]);
    expect(setFailures(after ?? mission, after?.failures ?? [])).toBeNull();
  });
});
