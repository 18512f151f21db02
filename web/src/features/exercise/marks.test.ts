import { expect, test } from "vitest";

import type { Exercise, GoalVerdict } from "../../api/generated";
import { moreWords } from "../../i18n/words";
import { groundOf, noMarks, OPEN, pieces, withVerdicts } from "./marks";
import { readRemembered } from "../../session/open-exercise";

await moreWords();

const goal = (kind: "program" | "run" | "check" | "watched") => ({ label: { "": kind }, kind });
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
  const one = withVerdicts(open, [verdict(true), verdict(null)], exercise.goals);
  expect(one).toEqual([{ ...OPEN, state: "reached" }, OPEN]);
  const two = withVerdicts(one, [verdict(false, 2), verdict(null)], exercise.goals);
  expect(two[0]).toEqual({ ...OPEN, state: "missed", why: "touches a wall", seed: 2, seconds: 3.5 });
  const proved = { ...verdict(true), why: "proved" };
  const three = withVerdicts(two, [verdict(true), proved], exercise.goals);
  expect(three).toEqual([two[0], { ...OPEN, state: "reached", why: "proved" }]);
});

test("a property that no check judged says in how many runs it was seen; one that never came up says so, and is open", () => {
  const goals = [goal("watched"), goal("check"), goal("run")];
  const never = { ...verdict(null), why: "it never comes to that" };
  const one = withVerdicts([OPEN, OPEN, OPEN], [never, verdict(true), verdict(true)], goals);
  expect(one.map(groundOf)).toEqual([never.why, "Seen in 1 run, which is no proof.", ""]);
  const two = withVerdicts(one, [verdict(true), verdict(true), verdict(true)], goals);
  const three = withVerdicts(two, [never, verdict(null), verdict(true)], goals);
  expect(three.map(groundOf)).toEqual(["Seen in 1 run, which is no proof.", "Seen in 2 runs, which is no proof.", ""]);
  expect([one[0]?.state, three[0]?.state]).toEqual(["open", "reached"]);
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
