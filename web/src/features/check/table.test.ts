import { expect, test } from "vitest";

import type { CheckedProperty, ConfirmingRun } from "../../api/generated";
import { plan, shapeOf, stretches } from "./table";
import { withFailures } from "../../session/confirming-run";

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
