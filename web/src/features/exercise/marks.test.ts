import { expect, test } from "vitest";

import type { Exercise, GoalVerdict } from "../../api/generated";
import { noMarks, OPEN, pieces, withVerdicts } from "./marks";
import { readRemembered } from "../../session/open-exercise";

const goal = (kind: "program" | "run" | "check") => ({ label: { "": kind }, kind });
const exercise: Exercise = {
  name: "x.exercise.xml",
  start: "x.krt",
  label: {},
  help: {},
  icon: "target",
  order: 1000,
  seconds: 60,
  seeds: [1, 2],
  goals: [goal("run"), goal("check")],
  problems: [],
};
const verdict = (reached: boolean | null, seed: number | null = null): GoalVerdict => ({
  reached,
  why: reached === false ? "touches a wall" : "",
  seed,
  seconds: seed === null ? null : 3.5,
});

test("a goal is reached when every piece says so, and missed as soon as one says that", () => {
  const open = noMarks(exercise);
  const one = withVerdicts(open, [verdict(true), verdict(null)]);
  expect(one).toEqual([{ ...OPEN, state: "reached" }, OPEN]);
  const two = withVerdicts(one, [verdict(false, 2), verdict(null)]);
  expect(two[0]).toEqual({ state: "missed", why: "touches a wall", seed: 2, seconds: 3.5 });
  expect(withVerdicts(two, [verdict(true), verdict(true)])).toEqual([two[0], { ...OPEN, state: "reached" }]);
});

test("each seed is a piece of judging, and checking is the last one where there is something to check", () => {
  expect(pieces(exercise)).toEqual([1, 2, null]);
  expect(pieces({ ...exercise, goals: [goal("run")] })).toEqual([1, 2]);
});

test("what is remembered of an exercise is read, and what makes no sense is not", () => {
  expect(readRemembered('{"name":"a","path":"b.krt"}')).toEqual({ name: "a", path: "b.krt" });
  for (const text of [null, "", "{", "[]", "3", '{"name":1,"path":"b"}', '{"name":"a"}']) {
    expect(readRemembered(text)).toBeNull();
  }
});
