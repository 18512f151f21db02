import { describe, expect, it } from "vitest";

import { partsOf } from "../../model/parts";
import { CARRIER_PARTS as CARRIER } from "../../model/testing/missions";
import { PARTS } from "../../model/testing/parts";
import type { Method, RobotObject } from "../../model/types";
import { tabsOf } from "./tree";

const names = (query = "", parts = CARRIER) => tabsOf(parts, query).map(({ name }) => name);
const labels = (tab: string, query = "", parts = CARRIER) =>
  tabsOf(parts, query)
    .find(({ name }) => name === tab)
    ?.rows.map(({ label }) => label);

/** The carrier, with its wheels said otherwise. */
function withWheel(object: Partial<RobotObject>, methods: Record<string, Partial<Method>> = {}) {
  const robots = PARTS.robots.map((robot) => ({
    ...robot,
    objects: robot.objects.map((one) =>
      one.name === "Wheel"
        ? { ...one, ...object, methods: one.methods.map((method) => ({ ...method, ...methods[method.name] })) }
        : one,
    ),
  }));
  return partsOf({ ...PARTS, robots }, "carrier");
}

describe("the palette's tabs", () => {
  it("are the groups of the XML in its order, those with nothing left out", () => {
    expect(names()).toEqual(["Sense", "Actions", "Loops", "Choices", "Parallel", "Conditions"]);
  });

  it("hold what names none by its kind, methods under their object, nothing closed", () => {
    expect(labels("Actions")?.slice(0, 6)).toEqual(["Wheel", "Advance", "Reverse", "Stop", "Motor", "AbsoluteTurn"]);
    expect(labels("Sense")).toContain("Sign");
    expect(labels("Conditions")?.slice(0, 3)).toEqual(["And", "Or", "No"]);
    expect(labels("Conditions")).toContain("Run");
  });

  it("have the way to a new variable behind the variables", () => {
    const rows = tabsOf(CARRIER, "").find(({ name }) => name === "Conditions")?.rows;
    const fresh = rows?.findIndex(({ kind }) => kind === "new") ?? -1;
    expect(rows?.slice(0, fresh).some((row) => row.kind === "object" && row.object.category === "system")).toBe(false);
    const behind = rows?.slice(fresh + 1).filter(({ kind }) => kind === "object") ?? [];
    expect(behind.every((row) => row.kind === "object" && row.object.category === "system")).toBe(true);
  });

  it("hold an object, and a method, in the group that it names", () => {
    expect(labels("Move", "", withWheel({ group: "Move" }))).toEqual(["Wheel", "Advance", "Reverse", "Stop"]);
    const other = withWheel({ group: "Move" }, { Stop: { group: "Loops" } });
    expect(labels("Loops", "", other)).toContain("Stop");
    // A group that is not there is as none.
    expect(labels("Actions", "", withWheel({ group: "Nowhere" }))).toContain("Advance");
  });

  it("begin with what says its place, in the order of the places, without its object", () => {
    const parts = withWheel({ group: "Move" }, { Stop: { order: 1 }, Advance: { order: 2 } });
    expect(labels("Move", "", parts)).toEqual(["Stop", "Advance", "Wheel", "Reverse"]);
    // Whoever compiles sees the order of the file.
    expect(parts.robot?.objects.find(({ name }) => name === "Wheel")?.methods[0]?.name).toBe("Advance");
  });

  it("keep at the end what no tab is for", () => {
    const parts = partsOf({ ...PARTS, groups: [] }, "carrier");
    expect(names("", parts)).toEqual([""]);
    expect(labels("", "", parts)).toContain("Advance");
  });

  it("say beside a part what it begins with", () => {
    const row = tabsOf(CARRIER, "")
      .flatMap(({ rows }) => rows)
      .find(({ label }) => label === "Advance");
    expect(row).toMatchObject({ kind: "part", aside: "50 %" });
  });

  it("are what matches while one searches, the best first, by whole names", () => {
    expect(labels("Actions", "light")).toEqual(["Lamp LightOn", "Lamp LightOff"]);
    expect(names("xyz")).toEqual([]);
    expect(names("wait")[0]).toBe("Choices");
  });
});
