/** The checklist of an exercise: goals and why they are missed, judging that is stopped, the run that shows what went wrong. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { exerciseApi } from "../../api/exercises";
import type { Exercise, GoalVerdict } from "../../api/generated";
import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { setOpenLesson, useLessons } from "../../session/lessons";
import { remember, setComments, setHandIn, useOpenExercise } from "../../session/open-exercise";
import { useRun } from "../../session/run";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted, settle } from "../../testing/hooks";
import { leave } from "./exercise-session";
import { ExercisePanel } from "./Panel";

await moreWords();

const MISSION = missionOf(CARRIER);
const EXERCISE: Exercise = {
  name: "x.exercise.xml",
  start: "test.krt",
  label: { "": "No jam" },
  help: { "": "Let all arrive." },
  icon: "",
  order: 1,
  seconds: 60,
  seeds: [1, 2],
  goals: [
    { label: { "": "All arrive" }, kind: "watched" },
    { label: { "": "Nobody touches" }, kind: "run" },
    { label: { "": "No deadlock" }, kind: "check" },
  ],
  problems: [],
};
const YES: GoalVerdict = { reached: true, why: "", seed: null, seconds: null };
const OPEN: GoalVerdict = { ...YES, reached: null };
const MISSED: GoalVerdict = { reached: false, why: "carrier-2 touches carrier-1", seed: 2, seconds: 2.04 };

let page: Mounted;
let hands: Hands;
const start = vi.fn();

beforeEach(async () => {
  localStorage.clear();
  start.mockClear();
  vi.spyOn(exerciseApi, "all").mockResolvedValue([EXERCISE]);
  vi.spyOn(exerciseApi, "stop").mockResolvedValue(undefined as never);
  vi.spyOn(exerciseApi, "judge").mockImplementation((_, mission, seed) =>
    Promise.resolve({ mission, goals: seed === null ? [OPEN, OPEN, YES] : [YES, seed === 2 ? MISSED : YES, OPEN] }),
  );
  useRun.setState({ start });
  useStudio.getState().openMission(fileOf(MISSION));
  remember({ name: EXERCISE.name, path: EXERCISE.start });
  page = mount(<ExercisePanel />);
  hands = handsOn(page);
  await settle();
});
afterEach(() => {
  page.act(leave);
  page.end();
  setComments({});
  setOpenLesson("exercise", null);
  useLessons.setState({ learned: [] });
  useRun.setState(useRun.getInitialState());
  vi.restoreAllMocks();
});

const state = (goal: number) => hands.find(`exercise-goal-${String(goal)}`).dataset["state"];
const says = () => hands.find("exercise-basis").textContent;

it("is there with the focus, and every goal is open", () => {
  expect(document.activeElement).toBe(hands.find("exercise"));
  expect(hands.find("exercise-count").textContent).toBe("0 of 3 goals");
  expect([state(1), state(2), state(3)]).toEqual(["open", "open", "open"]);
});

it("judges every run; what went wrong is told and is played as it was judged, and is not judged once more", async () => {
  await settle(() => hands.click("exercise-judge"));
  expect(says()).toBe("Judged in 2 runs.");
  expect([state(1), state(2), state(3)]).toEqual(["reached", "missed", "reached"]);
  expect(hands.find("exercise-count").textContent).toBe("2 of 3 goals");
  expect(hands.find("exercise-goal-1").textContent).toContain("Seen in 2 runs, which is no proof.");
  const goal = hands.find("exercise-goal-2");
  expect(goal.textContent).toContain("carrier-2 touches carrier-1");
  const watch = [...goal.querySelectorAll("button")].find(({ textContent }) => textContent?.includes("at 2.0 s"));
  page.act(() => watch?.click());
  expect(start.mock.calls[0]?.[1]).toMatchObject({ mission: MISSION, path: EXERCISE.start, seed: 2, seconds: 60 });
  await settle(() => useRun.setState({ status: "running", seed: 2, mission: MISSION }));
  await settle(() => useRun.setState({ status: "done" }));
  expect([says(), vi.mocked(exerciseApi.judge).mock.calls.length]).toEqual(["Judged in 2 runs.", 3]);
  // Another run is judged.
  await settle(() => useRun.setState({ status: "running", seed: 2, mission: MISSION }));
  await settle(() => useRun.setState({ status: "done" }));
  expect(says()).toContain("After the run with seed 2");
});

it("stops judging with what was found, and is old after an edit", async () => {
  let answer: () => void = () => undefined;
  vi.mocked(exerciseApi.judge).mockImplementation(
    (_, mission) => new Promise((resolve) => (answer = () => resolve({ mission, goals: [YES, OPEN, OPEN] }))),
  );
  await settle(() => hands.click("exercise-judge"));
  hands.click("exercise-stop");
  await settle(answer);
  expect(exerciseApi.stop).toHaveBeenCalled();
  expect(says()).toContain("stopped");
  expect([state(1), state(2), vi.mocked(exerciseApi.judge).mock.calls.length]).toEqual(["reached", "open", 1]);
  await settle(() =>
    useStudio.getState().execute({ label: "Edit", execute: (mission) => ({ ...mission, world: "w" }) }),
  );
  expect(says()).toContain("changed");
});

it("shows what the teacher wrote on it, and is left", async () => {
  page.act(() => setComments({ [EXERCISE.name]: "A fine start" }));
  expect(hands.find("exercise-comment").textContent).toContain("A fine start");
  await settle(() => hands.click("exercise-leave"));
  expect(hands.has("exercise")).toBe(false);
});

it("hands in where there is somebody to hand in to", async () => {
  expect(hands.has("exercise-hand-in")).toBe(false);
  const handIn = vi.fn();
  await settle(() => setHandIn(handIn));
  hands.click("exercise-hand-in");
  expect(handIn).toHaveBeenCalledOnce();
  await settle(() => setHandIn(null));
  expect(hands.has("exercise-hand-in")).toBe(false);
});

it("stays with work that has no path yet, whatever it is called, and leaves with another one", async () => {
  const unsaved = { ...fileOf(MISSION), path: "", name: "mine.krt" };
  page.act(() => remember({ name: EXERCISE.name, path: "mine.krt" }));
  await settle(() => useStudio.getState().openMission(unsaved));
  expect(hands.has("exercise")).toBe(true);
  await settle(() => useStudio.getState().openMission({ ...unsaved, name: "other.krt" }));
  expect([hands.has("exercise"), useOpenExercise.getState().open]).toEqual([false, null]);
});
