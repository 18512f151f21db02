import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import type { Mission, Report } from "../model/types";
import { makeChecker } from "./checking";

const MISSION: Mission = {
  version: 1,
  programs: [{ name: "program-1", robot: "r", vertices: [], arcs: [] }],
  agents: [{ name: "r-1", program: "program-1", start: "" }],
  goals: [],
  world: "",
};

describe("the checker", () => {
  beforeEach(() => vi.useFakeTimers());
  afterEach(() => vi.useRealTimers());

  const report = (lll: string): Report => ({
    programs: [{ name: "p", lll, spans: [], instructions: 0 }],
    problems: [],
  });

  it("asks at once, and once more for all edits that follow meanwhile", async () => {
    const check = vi.fn().mockResolvedValue(report("a"));
    const accept = vi.fn();
    const ask = makeChecker({ check, accept, fail: vi.fn() });
    ask(MISSION, "1");
    expect(check).toHaveBeenCalledTimes(1);
    for (const path of ["2", "3"]) ask(MISSION, path);
    await vi.advanceTimersByTimeAsync(100);
    expect(check.mock.calls.map((given: unknown[]) => given[1])).toEqual(["1", "3"]);
    expect(accept).toHaveBeenCalledTimes(1);
  });

  it("asks one question at a time, and drops an answer that was overtaken", async () => {
    const answers: ((report: Report) => void)[] = [];
    const check = vi.fn(() => new Promise<Report>((resolve) => answers.push(resolve)));
    const accept = vi.fn<(report: Report, mission: Mission) => void>();
    const ask = makeChecker({ check, accept, fail: vi.fn() });
    ask(MISSION, "first");
    await vi.advanceTimersByTimeAsync(100);
    for (const path of ["second", "third"]) ask(MISSION, path);
    await vi.advanceTimersByTimeAsync(100);
    expect(check.mock.calls.map((given: unknown[]) => given[1])).toEqual(["first"]);
    answers[0]?.(report("old"));
    await vi.advanceTimersByTimeAsync(1);
    expect(check.mock.calls.map((given: unknown[]) => given[1])).toEqual(["first", "third"]);
    answers[1]?.(report("new"));
    await vi.advanceTimersByTimeAsync(1);
    expect(accept.mock.calls.map(([one]) => one.programs[0]?.lll)).toEqual(["new"]);
  });

  it("does not ask about what is known", async () => {
    const check = vi.fn().mockResolvedValue(report("a"));
    const ask = makeChecker({ check, accept: vi.fn(), fail: vi.fn(), known: (mission) => mission === MISSION });
    ask(MISSION, "");
    await vi.advanceTimersByTimeAsync(100);
    ask({ ...MISSION }, "");
    await vi.advanceTimersByTimeAsync(100);
    expect(check).toHaveBeenCalledTimes(1);
  });

  it("says a failure, but not that of a question that was overtaken, and asks on", async () => {
    const failures: ((cause: Error) => void)[] = [];
    const check = vi.fn(() => new Promise<Report>((_, reject) => failures.push(reject)));
    const fail = vi.fn<(cause: unknown) => void>();
    const ask = makeChecker({ check, accept: vi.fn(), fail });
    ask(MISSION, "");
    await vi.advanceTimersByTimeAsync(100);
    ask(MISSION, "");
    failures[0]?.(new Error("overtaken"));
    await vi.advanceTimersByTimeAsync(100);
    failures[1]?.(new Error("gone"));
    await vi.advanceTimersByTimeAsync(1);
    expect(fail.mock.calls).toEqual([[new Error("gone")]]);
    ask(MISSION, "");
    await vi.advanceTimersByTimeAsync(1);
    expect(check).toHaveBeenCalledTimes(3);
  });
});
