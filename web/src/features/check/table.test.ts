import { expect, test } from "vitest";

import type { CheckedProperty, ConfirmingRun } from "../../api/generated";
import { withFailures } from "../../session/confirming-run";
import { counterexampleMarks, momentsFrom, plan, repeatedFrom, sceneAt, shapeOf, stretches } from "./table";

const BROKEN: CheckedProperty = {
  name: "contact",
  sentence: "",
  answer: "broken",
  steps: 3,
  repeats_from: -1,
  events: [0, 1, 1, 2].map((step) => ({ step, text: String(step) })),
  left_out: 0,
  confirmed: null,
  searched: true,
  scenes: [],
  guilty: [],
  places: [],
  why: null,
};

test("assumptions go from the fast to the thorough", () => {
  expect(plan(1).map(({ timing, failures }) => `${timing} ${String(failures)}`)).toEqual(
    [0, 1].flatMap((failures) => ["lockstep", "prompt", "free"].map((timing) => `${timing} ${String(failures)}`)),
  );
});

test("what no run of the simulator shows looks otherwise, and what is not there yet waits, runs or was never begun", () => {
  const run: ConfirmingRun = { seed: 1, tick: 2, seconds: 0.04, failures: [] };
  expect(shapeOf(BROKEN, false, false)).toBe("unconfirmed");
  expect(shapeOf({ ...BROKEN, confirmed: run }, false, false)).toBe("broken");
  expect(shapeOf({ ...BROKEN, answer: "not finished" }, true, true)).toBe("cut");
  expect([shapeOf(undefined, true, false), shapeOf(undefined, true, true), shapeOf(undefined, false, true)]).toEqual([
    "waits",
    "running",
    "none",
  ]);
});

test("a run that repeats is told in two parts, and one that stays as it is has nothing in the second", () => {
  const told = (from: number) =>
    stretches({ ...BROKEN, repeats_from: from }).map(({ repeats, events }) => [repeats, events.length]);
  expect(told(-1)).toEqual([[false, 4]]);
  expect(told(1)).toEqual([
    [false, 1],
    [true, 3],
  ]);
  expect(told(3)).toEqual([
    [false, 4],
    [true, 0],
  ]);
});

test("a run is played with what befell agents among the failures on the schedule, and the mission stays as it is", () => {
  const later = { agent: "b", at_s: 9, kind: "mute" as const };
  const mission = { version: 1 as const, programs: [], agents: [], goals: [], world: "", failures: [later] };
  const harm = { agent: "a", at_s: 4.5, kind: "stall" as const };
  const run: ConfirmingRun = { seed: 1, tick: 300, seconds: 6, failures: [harm] };
  expect(withFailures(mission, run).failures).toEqual([harm, later]);
  expect(mission.failures).toEqual([later]);
  const { failures: _, ...plain } = mission;
  expect(withFailures(plain, { ...run, failures: [] })).toBe(plain);
});

const at = (vertex: string) => ({ x_mm: 0, y_mm: 0, heading_rad: 0, at: [["p", vertex]] as [string, string][] });
const LASSO: CheckedProperty = {
  ...BROKEN,
  repeats_from: 1,
  scenes: [
    { step: 0, robots: [at("v1"), at("v9")] },
    { step: 1, robots: [at("v2"), at("v8")] },
    { step: 2, robots: [at("v3"), at("v9")] },
    { step: 3, robots: [at("v2"), at("v9")] },
  ],
  guilty: [
    { agent: "a", program: "p", vertex: "v2", sentence: "a waits", repeats: true },
    { agent: "b", program: "p", vertex: "v9", sentence: "b waits", repeats: true },
  ],
};

test("what repeats goes on from where it began", () => {
  expect(repeatedFrom(LASSO)).toBe(2);
  expect(repeatedFrom({ ...LASSO, repeats_from: -1 })).toBeNull();
  expect(repeatedFrom({ ...LASSO, repeats_from: 3 }), "it stays as it is").toBeNull();
});

test("guilty vertices have their robots and one sentence a program, and vertices on the way the steps that come to them", () => {
  const found = counterexampleMarks(LASSO, ["a", "b"]).map(({ vertex, sentence, robots, steps }) => [
    vertex,
    sentence,
    robots.join(),
    steps.join(),
  ]);
  expect(found).toEqual([
    ["v2", "a waits", "a", "1,3"],
    ["v9", "", "b", "2"],
    ["v8", "", "", "1"],
    ["v3", "", "", "2"],
  ]);
  expect(counterexampleMarks(BROKEN, ["a"])).toEqual([]);
});

test("runs in step show what they have: a repeating one goes round, another stays at its end", () => {
  const scenes = [0, 1, 2, 5].map((step) => ({ step, robots: [] }));
  const run = { ...BROKEN, scenes, steps: 5 };
  expect(momentsFrom([run, { ...run, scenes: [3, 5, 7].map((step) => ({ step, robots: [] })) }], 2)).toEqual([
    2, 3, 5, 7,
  ]);
  expect([2, 4, 5, 9].map((step) => sceneAt(run, step)?.step)).toEqual([2, 2, 5, 5]);
  const round = { ...run, scenes: scenes.slice(0, 3), steps: 2, repeats_from: 0 };
  expect([1, 2, 3, 4, 5].map((step) => sceneAt(round, step)?.step)).toEqual([1, 2, 1, 2, 1]);
  expect(sceneAt({ ...run, scenes: [] }, 1)).toBeNull();
});
