import { describe, expect, it } from "vitest";

import { setNote } from "./commands/setNote";
import { findIn, MOST_HITS } from "./find";
import { CARRIER, CARRIER_PARTS as PARTS, missionOf } from "./testing/missions";
import type { Program, Report } from "./types";

const find = (query: string, programs: Program[] = [CARRIER], report: Report | null = null) =>
  findIn(programs, () => PARTS, report, query);
const ids = (query: string, programs?: Program[], report?: Report) =>
  find(query, programs, report).map((hit) => hit.vertex);

describe("finding", () => {
  it("finds by name, by element and by what is written in a condition", () => {
    expect(ids("lamp")).toEqual(["v6", "v20"]);
    expect(ids("Lamp.LightOff")).toEqual(["v20"]);
    expect(ids("when cargo")).toEqual(["v18"]);
  });

  it("finds values by their label and number", () => {
    expect(ids("wheel speed 50")).toEqual(["v8", "v17"]);
  });

  it("finds notes and shows them", () => {
    const noted = setNote(CARRIER, "v20", "Dark means empty")?.execute(missionOf(CARRIER)).programs[0] ?? CARRIER;
    expect(find("dark", [noted])).toMatchObject([{ vertex: "v20", aside: "Dark means empty" }]);
  });

  it("finds the words of LLL, only in the line of the vertex itself", () => {
    const lll = "*[Run.IsTrue()](\n  //(\n";
    const spans = [
      { vertex: "v1", start: 0, end: lll.length, line: 1 },
      { vertex: "v3", start: 19, end: 22, line: 2 },
    ];
    const report = {
      programs: [{ name: "carrier", lll, spans, instructions: 0 }],
      problems: [],
    };
    expect(ids("//(", undefined, report)).toEqual(["v3"]);
    expect(ids("*[", undefined, report)).toEqual(["v1"]);
  });

  it("looks through all programs, in their order", () => {
    const other = { ...CARRIER, name: "other" };
    expect(find("dark", [CARRIER, other])).toEqual([]);
    expect(find("lighton", [CARRIER, other]).map((hit) => hit.program)).toEqual(["carrier", "other"]);
  });

  it("finds nothing for nothing, and stops at a full list", () => {
    expect(ids("  ")).toEqual([]);
    expect(ids("(")).toEqual([]);
    const many = Array.from({ length: 40 }, () => CARRIER);
    expect(find("i", many)).toHaveLength(MOST_HITS);
  });
});
