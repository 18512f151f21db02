/** After a run: what is judged of itself, and when an exercise is solved. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { api } from "../../api/client";
import { exerciseApi } from "../../api/exercises";
import type { Exercise, GoalVerdict } from "../../api/generated";
import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { useDocument } from "../../session/document";
import { openLesson, setOpenLesson, useLessons } from "../../session/lessons";
import { remember, useOpenExercise } from "../../session/open-exercise";
import { useRun } from "../../session/run";
import { keepExercise, leave, openLinked, useExercise } from "./exercise-session";

await moreWords();

const goal = (kind: "run" | "check") => ({ label: { "": kind }, kind });
const exercise: Exercise = {
  name: "x.exercise.xml",
  start: "x.krt",
  label: {},
  help: {},
  icon: "",
  order: 1,
  seconds: 60,
  seeds: [1, 2],
  goals: [goal("run"), goal("check")],
  problems: [],
};
const verdict = (reached: boolean | null): GoalVerdict => ({ reached, why: "", seed: null, seconds: null });

let end: () => void;
let asked: (number | null)[];
let missed: number | null;

beforeEach(async () => {
  localStorage.clear();
  [asked, missed] = [[], null];
  vi.spyOn(exerciseApi, "all").mockResolvedValue([exercise]);
  vi.spyOn(exerciseApi, "judge").mockImplementation((_, mission, seed) => {
    asked.push(seed);
    const goals = seed === null ? [verdict(null), verdict(true)] : [verdict(seed !== missed), verdict(null)];
    return Promise.resolve({ goals, mission });
  });
  end = keepExercise();
  remember({ name: exercise.name, path: exercise.start });
  await vi.waitFor(() => expect(useExercise.getState().all).not.toBeNull());
});
afterEach(() => {
  leave();
  end();
  useRun.setState({ status: "idle", mission: null });
  useLessons.setState({ learned: [] });
  setOpenLesson("exercise", null);
  vi.restoreAllMocks();
});

async function runWith(seed: number): Promise<void> {
  useRun.setState({ status: "running", seed, mission: useStudio.getState().mission });
  useRun.setState({ status: "done" });
  await vi.waitFor(() => expect([useExercise.getState().busy, asked.length > 0]).toEqual([null, true]));
}
const lesson = () => openLesson(useLessons.getState());

it("a run that misses nothing has the other runs judged, and what is checked: then the exercise is solved", async () => {
  await runWith(1);
  await vi.waitFor(() => expect(lesson()).toEqual({ name: exercise.name, done: true }));
  expect(asked).toEqual([1, 2, null]);
  expect(useExercise.getState().basis).toEqual({ kind: "all", runs: 2 });
  expect(useLessons.getState().learned).toEqual([exercise.name]);
});

it("a run that misses a goal is judged alone, and the exercise is not solved", async () => {
  missed = 1;
  await runWith(1);
  expect([asked, useExercise.getState().basis.kind, lesson()?.done]).toEqual([[1], "run", false]);
});

it("where another run misses a goal the exercise is not solved", async () => {
  missed = 2;
  await runWith(1);
  await vi.waitFor(() => expect(asked).toEqual([1, 2, null]));
  await vi.waitFor(() => expect(useExercise.getState().basis.kind).toBe("all"));
  expect([useExercise.getState().marks[0]?.state, lesson()?.done]).toEqual(["missed", false]);
});

it("an exercise that was solved is open again after an edit, and stays learned", async () => {
  await runWith(1);
  await vi.waitFor(() => expect(lesson()?.done).toBe(true));
  useExercise.setState({ old: true });
  expect([lesson()?.done, useLessons.getState().learned]).toEqual([false, [exercise.name]]);
});

it("opens the exercise of a link once, and leaves what is worked on as it is", async () => {
  const opened = vi.spyOn(api, "mission").mockResolvedValue({ ...fileOf(missionOf(CARRIER)), path: exercise.start });
  useDocument.setState({ ready: true, banner: null });
  useStudio.getState().openMission({ ...fileOf(missionOf(CARRIER)), path: "other.krt", name: "other.krt" });
  window.history.replaceState(null, "", `#exercise=${exercise.name}`);
  await openLinked(exercise.name);
  await vi.waitFor(() => expect(useStudio.getState().file.path).toBe(exercise.start));
  expect(window.location.hash).toBe("");
  expect(useOpenExercise.getState().open).toEqual({ name: exercise.name, path: exercise.start });
  useStudio.getState().execute({ label: "Edit", execute: (mission) => ({ ...mission, world: "w.world.xml" }) });
  await openLinked(exercise.name);
  expect([opened.mock.calls.length, useStudio.getState().mission.world]).toEqual([1, "w.world.xml"]);
});

it("says of a link to no exercise that it is not here, and opens nothing", async () => {
  const opened = vi.spyOn(api, "mission");
  useDocument.setState({ ready: true, banner: null });
  await openLinked("none.exercise.xml");
  const { banner } = useDocument.getState();
  expect([banner?.kind, banner?.message]).toEqual([
    "error",
    "The exercise of this link is not here: none.exercise.xml",
  ]);
  expect(opened).not.toHaveBeenCalled();
});
