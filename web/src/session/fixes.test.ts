import { beforeEach, describe, expect, it } from "vitest";

import { useStudio } from "../model/studio";
import { fileOf, missionOf } from "../model/testing/missions";
import type { Fix, Problem, Program } from "../model/types";
import { applyFix, canFix } from "./fixes";
import { connectTyping, setFocused, typeText, useTyping } from "./typing";

const PROGRAM: Program = {
  name: "p",
  robot: "carrier",
  vertices: [
    { id: "start", element: "Start", settings: {}, notes: [] },
    { id: "v1", element: "Wheel.Advanse", settings: { speed: "500", sped: "3" }, notes: [] },
    { id: "stop", element: "Stop", settings: {}, notes: [] },
  ],
  arcs: [
    { source: "start", target: "v1", out: "next", at: "in" },
    { source: "v1", target: "stop", out: "next", at: "in" },
  ],
};

function problem(fix: Fix | null, more: Partial<Problem> = {}): Problem {
  const place = { file: "p.lll", line: 1, column: 1, end_line: 1, end_column: 1 };
  const words = { severity: "error" as const, code: "c", message: "m", help: "" };
  return { ...place, ...words, program: "p", vertices: ["v1"], arcs: [], fix, ...more };
}

const vertexNow = () => useStudio.getState().mission.programs[0]?.vertices[1];

beforeEach(() => {
  useStudio.getState().openMission(fileOf(missionOf(PROGRAM)));
});

describe("a fix of the graph", () => {
  it("gives a vertex the element that was meant, and undo takes it back", () => {
    const wrong = problem({ kind: "element", name: "Wheel.Advance", text: "Advance(500)" });
    expect(canFix(wrong)).toBe(true);
    expect(applyFix(wrong)).toBe(true);
    expect(vertexNow()?.element).toBe("Wheel.Advance");
    expect(canFix(wrong)).toBe(false);
    useStudio.getState().undo();
    expect(vertexNow()).toBe(PROGRAM.vertices[1]);
  });

  it("sets a value, and takes one away", () => {
    applyFix(problem({ kind: "setting", name: "speed", text: "100" }));
    applyFix(problem({ kind: "unset", name: "sped", text: "" }));
    expect(vertexNow()?.settings).toEqual({ speed: "100" });
  });

  it("puts a part before the end", () => {
    const early = problem({ kind: "before", name: "Wait", text: "WAIT(10);" }, { vertices: ["stop"] });
    expect(applyFix(early)).toBe(true);
    const { vertices, arcs } = useStudio.getState().mission.programs[0] ?? PROGRAM;
    const pause = vertices.find(({ element }) => element === "Wait");
    expect(arcs.map(({ source, target }) => [source, target])).toEqual([
      ["start", "v1"],
      ["v1", pause?.id],
      [pause?.id, "stop"],
    ]);
    useStudio.getState().undo();
    expect(useStudio.getState().mission.programs[0]?.arcs).toEqual(PROGRAM.arcs);
  });

  it("is not offered for what is not there", () => {
    const fix: Fix = { kind: "setting", name: "speed", text: "100" };
    expect(canFix(problem(fix, { program: "q" }))).toBe(false);
    expect(canFix(problem(fix, { vertices: ["v9"] }))).toBe(false);
    expect(canFix(problem(fix, { vertices: [] }))).toBe(false);
    expect(canFix(problem(null))).toBe(false);
    expect(canFix(problem({ kind: "text", name: "", text: ";" }))).toBe(false);
    expect(applyFix(problem({ kind: "unset", name: "other", text: "" }))).toBe(false);
  });
});

describe("a fix of a text that is being written", () => {
  it("changes the text at the place of the problem", async () => {
    const missing = problem({ kind: "text", name: "", text: ";" }, { line: 2, column: 5, end_line: 2, end_column: 5 });
    const answers = [{ program: null, spans: [], report: null, problems: [missing] }];
    const end = connectTyping(() =>
      Promise.resolve(answers[0] ?? { program: null, spans: [], report: null, problems: [] }),
    );
    setFocused("p", true);
    typeText("p", "a.b()\nc.d()", { text: "", spans: [] });
    await expect.poll(() => useTyping.getState().drafts["p"]?.waiting).toBe(false);
    const told = useTyping.getState().drafts["p"]?.problems[0];
    expect(told).toBe(missing);
    expect(canFix(missing)).toBe(true);
    applyFix(missing);
    expect(useTyping.getState().drafts["p"]?.text).toBe("a.b()\nc.d(;)");
    end();
  });
});
