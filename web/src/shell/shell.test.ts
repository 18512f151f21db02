import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import type { Mission, Report, World } from "../api/types";
import type { RunEvent } from "../api/wire";
import { freeName, nextSpeed, programWithAgent } from "./actions";
import { makeChecker } from "./checking";
import { axisTime, clock, grouped } from "../words/numbers";
import { axisFor, thinned } from "./EventStrip";
import { readLayout, USUAL } from "./layout";
import { itemByLetter, type MenuEntry, stepItem } from "./menu-model";
import { asMissionPath } from "./SaveAsSheet";
import { MAX_POSITION, positionOf, speedAt } from "./speed";

const MISSION: Mission = {
  version: 1,
  programs: [{ name: "program-1", robot: "r", vertices: [], arcs: [] }],
  agents: [{ name: "r-1", program: "program-1", start: "" }],
  goals: [],
  world: "",
};

function worldWith(...starts: string[]): World {
  const lists = { walls: [], roads: [], docks: [], storehouses: [] };
  const at = { x_mm: 0, y_mm: 0, heading_rad: 0 };
  return { name: "w", width_mm: 1, height_mm: 1, ...lists, starts: starts.map((name) => ({ name, ...at })) };
}

describe("the checker", () => {
  beforeEach(() => vi.useFakeTimers());
  afterEach(() => vi.useRealTimers());

  const report = (lll: string): Report => ({
    programs: [{ name: "p", lll, spans: [], listing: "", instructions: 0 }],
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

describe("times", () => {
  it.each([
    [0, "00:00.0"],
    [42.6, "00:42.6"],
    [59.99, "00:59.9"],
    [3661.2, "61:01.2"],
    [-1, "00:00.0"],
  ])("%d s is %s", (seconds, words) => expect(clock(seconds)).toBe(words));

  it("on the axis have no tenths", () => expect([axisTime(0), axisTime(70)]).toEqual(["0:00", "1:10"]));

  it("group the digits of a tick", () => expect([grouped(21), grouped(2130)]).toEqual(["21", "2\u20091" + "30"]));
});

describe("the speed slider", () => {
  it.each([
    [0, 0.1],
    [33, 1],
    [100, 100],
    [MAX_POSITION, 0],
  ])("at %d means %d", (position, speed) => expect(speedAt(position)).toBe(speed));

  it("finds every round speed again", () => {
    for (const speed of [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 0]) expect(speedAt(positionOf(speed))).toBe(speed);
  });

  it("steps through its notches and stops at the ends", () => {
    expect([nextSpeed(1, 1), nextSpeed(1, -1), nextSpeed(3, 1), nextSpeed(3, -1)]).toEqual([2, 0.5, 5, 2]);
    expect([nextSpeed(100, 1), nextSpeed(0, 1), nextSpeed(0, -1), nextSpeed(0.1, -1)]).toEqual([0, 0, 100, 0.1]);
  });
});

describe("a new program", () => {
  it("brings an agent that runs it, and both go with undo", () => {
    const made = programWithAgent(MISSION, "mini-robot", worldWith("r-1", "r-2"));
    const after = made?.command.execute(MISSION);
    expect(made?.name).toBe("program-2");
    expect(after?.agents.at(-1)).toEqual({ name: "r-2", program: "program-2", start: "" });
    expect(after === undefined ? null : made?.command.revert(after)).toEqual(MISSION);
  });

  it("comes alone where the world has no place left", () => {
    const made = programWithAgent(MISSION, "mini-robot", worldWith("r-1"));
    expect(made?.command.execute(MISSION).agents).toEqual(MISSION.agents);
  });

  it("takes the first name that is free", () => {
    expect(freeName("a", ["a-1", "a-3"])).toBe("a-2");
  });
});

describe("the layout", () => {
  it("is the usual one without a memory, or with a broken one", () => {
    expect(readLayout(null).sizes).toEqual(USUAL);
    expect(readLayout("{broken").sizes).toEqual(USUAL);
    expect(readLayout('"a word"').sizes).toEqual(USUAL);
  });

  it("keeps remembered sizes within their limits", () => {
    const { sizes, folded } = readLayout('{"sizes":{"palette":9999,"side":"wide","code":250},"folded":{"arena":true}}');
    expect(sizes).toEqual({ ...USUAL, palette: 400, code: 250 });
    expect(folded).toMatchObject({ arena: true, palette: false });
  });
});

describe("a menu", () => {
  const item = (label: string): MenuEntry => ({ kind: "item", id: label, label, run: () => undefined });
  const entries: MenuEntry[] = [
    { kind: "heading", id: "h", label: "Head" },
    item("Open"),
    { kind: "line", id: "l" },
    item("Save"),
    item("Save as"),
  ];

  it("walks over its items round and round", () => {
    expect(stepItem(entries, -1, 1)).toBe(1);
    expect(stepItem(entries, 1, 1)).toBe(3);
    expect(stepItem(entries, 4, 1)).toBe(1);
    expect(stepItem(entries, -1, -1)).toBe(4);
    expect(stepItem(entries, 1, -1)).toBe(4);
  });

  it("finds items by their first letter, one after another", () => {
    expect(itemByLetter(entries, -1, "s")).toBe(3);
    expect(itemByLetter(entries, 3, "S")).toBe(4);
    expect(itemByLetter(entries, 4, "s")).toBe(3);
    expect(itemByLetter(entries, 0, "x")).toBe(-1);
  });

  it("without items has nowhere to go", () => expect(stepItem([{ kind: "line", id: "l" }], -1, 1)).toBe(-1));
});

describe("the strip of events", () => {
  const event = (tick: number, kind: RunEvent["kind"]): RunEvent => ({
    tick,
    kind,
    agent: "a",
    text: "",
    cause: "program",
  });

  it("doubles its axis before the label of the moment leaves it", () => {
    expect(axisFor(0).length).toBe(60);
    expect(axisFor(51).length).toBe(60);
    expect(axisFor(52).length).toBe(120);
    expect(axisFor(600).length).toBe(960);
  });

  it("keeps the weightier of two events that would lie on each other", () => {
    const events = [event(8, "message"), event(11, "load"), event(50, "unload")];
    expect(thinned(events, (one) => one.tick, 9).map((one) => one.kind)).toEqual(["load", "unload"]);
  });
});

it.each([
  ["walk", "walk.krt"],
  [" walk.krt ", "walk.krt"],
  ["Walk.KRT", "Walk.KRT"],
  ["  ", ""],
])("saving as %j writes %j", (typed, path) => expect(asMissionPath(typed)).toBe(path));
