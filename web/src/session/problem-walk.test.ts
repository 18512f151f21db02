import { beforeEach, describe, expect, it } from "vitest";

import { emptyProgram } from "../model/commands/changePrograms";
import { useStudio } from "../model/studio";
import type { Problem } from "../model/types";
import { closeDock, useDock } from "./dock";
import { orderProblems, PROBLEMS, standAt, useProblemWalk, walkProblems } from "./problem-walk";

function problem(severity: Problem["severity"], message: string, program = "", vertices: string[] = []): Problem {
  const place = { file: "a.krt", line: 1, column: 1, end_line: 1, end_column: 2 };
  return { ...place, severity, code: "some-code", message, help: "", program, vertices, arcs: [] };
}

const report = (...problems: Problem[]) => ({ programs: [], problems });

beforeEach(() => {
  useStudio.getState().openMission({
    path: "a.krt",
    name: "a.krt",
    revision: "",
    mission: {
      version: 1,
      programs: [emptyProgram("one", "r"), emptyProgram("two", "r")],
      agents: [],
      goals: [],
      world: "",
    },
    problems: [],
    world: null,
    catalogue: { groups: [], robots: [], problems: [] },
  });
  closeDock();
  standAt(-1);
});

describe("the order of problems", () => {
  it("is errors, warnings, hints, each as the server said them", () => {
    const found = orderProblems(
      report(problem("hint", "h"), problem("error", "e1"), problem("warning", "w"), problem("error", "e2")),
      [],
    );
    expect(found.map((one) => one.message)).toEqual(["e1", "e2", "w", "h"]);
  });

  it("has what the file and the run say besides, once", () => {
    const found = orderProblems(report(problem("error", "same")), [problem("error", "same"), problem("error", "more")]);
    expect(found.map((one) => one.message)).toEqual(["same", "more"]);
  });
});

describe("the walk", () => {
  it("opens the list, shows the program and selects the vertex", () => {
    useStudio.getState().setReport(report(problem("error", "e", "two", ["start"])));
    walkProblems(1);
    expect([useDock.getState().open, useProblemWalk.getState().at]).toEqual([PROBLEMS, 0]);
    expect([useStudio.getState().activeProgram, useStudio.getState().selection]).toEqual(["two", ["start"]]);
  });

  it("goes round in both directions", () => {
    useStudio.getState().setReport(report(problem("error", "a"), problem("error", "b")));
    walkProblems(-1);
    expect(useProblemWalk.getState().at).toBe(1);
    walkProblems(1);
    expect(useProblemWalk.getState().at).toBe(0);
    walkProblems(-1);
    expect(useProblemWalk.getState().at).toBe(1);
  });

  it("selects the ends of an arc, and nothing that is gone", () => {
    const arcs: Problem["arcs"] = [["start", "next", "v99", "in"]];
    useStudio.getState().setReport(report({ ...problem("error", "e", "one"), arcs }));
    walkProblems(1);
    expect(useStudio.getState().selection).toEqual(["start"]);
  });

  it("does nothing without problems", () => {
    walkProblems(1);
    expect(useDock.getState().open).toBeNull();
  });
});
