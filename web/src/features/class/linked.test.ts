/** A link to an exercise: what it opens, what it leaves as it is, and what is said where it opens nothing. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { classApi } from "../../api/class";
import { api } from "../../api/client";
import { exerciseApi } from "../../api/exercises";
import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { useDocument } from "../../session/document";
import { remember, useOpenExercise } from "../../session/open-exercise";
import { openLinked } from "./linked";

await moreWords();

const NAME = "example:square.exercise.xml";
const START = "example:square.krt";
const FILE = fileOf(missionOf(CARRIER));
const openWork = vi.fn(() => Promise.resolve());
const works = vi.fn(() => Promise.resolve([{ name: "mine.krt", bytes: 1, modified: "", exercise: NAME }]));

beforeEach(() => {
  const exercise = { name: NAME, start: START, label: { "": "Square" }, goals: [{}] };
  vi.spyOn(exerciseApi, "all").mockResolvedValue([
    exercise as never,
    { ...exercise, name: "broken", goals: [] } as never,
  ]);
  vi.spyOn(classApi, "exercise").mockResolvedValue(new ArrayBuffer(0));
  vi.spyOn(classApi, "works").mockImplementation(works);
  vi.spyOn(api, "mission").mockResolvedValue({ ...FILE, path: START, name: "square.krt" });
  useStudio.getState().openMission({ ...FILE, path: "", name: "other.krt" });
  useDocument.setState({ ready: true, banner: null });
});
afterEach(() => {
  remember(null);
  window.history.replaceState(null, "", "#");
  vi.clearAllMocks();
  vi.restoreAllMocks();
});

async function follow(hash: string, className = "5b", waits = false): Promise<string | undefined> {
  window.history.replaceState(null, "", hash);
  await openLinked({ className, waits: () => waits, openWork });
  return useDocument.getState().banner?.message;
}

const opens = () => vi.waitFor(() => expect(useStudio.getState().file.path).toBe(START));

it("opens what was handed in for the exercise, and follows the link once", async () => {
  expect(await follow(`#exercise=${encodeURIComponent(NAME)}&class=5b&code=ABCDEF`)).toBeUndefined();
  expect(openWork.mock.calls).toEqual([["mine.krt", NAME]]);
  expect(window.location.hash).toBe("");
  await openLinked({ className: "5b", waits: () => false, openWork });
  expect(openWork).toHaveBeenCalledOnce();
});

it("begins the exercise where nothing was handed in for it", async () => {
  works.mockResolvedValueOnce([]);
  await follow(`#exercise=${NAME}`);
  await opens();
  expect(useOpenExercise.getState().open).toEqual({ name: NAME, path: START });
  expect(classApi.exercise).toHaveBeenCalledWith(NAME);
});

it("leaves what is open on that exercise as it is: it is the newest", async () => {
  remember({ name: NAME, path: "other.krt" });
  useStudio.getState().execute({ label: "Edit", execute: (mission) => ({ ...mission, world: "w.world.xml" }) });
  expect(await follow(`#exercise=${NAME}`)).toBeUndefined();
  expect([openWork, works].map((one) => one.mock.calls.length)).toEqual([0, 0]);
  expect(useStudio.getState().mission.world).toBe("w.world.xml");
});

it.each([
  ["waits to be handed in", "5b", true],
  ["is here while the class does not answer", "", false],
])("goes on from what %s", async (_, className, waits) => {
  await follow(`#exercise=${NAME}&class=5b`, className, waits);
  await opens();
  expect([openWork, works].map((one) => one.mock.calls.length)).toEqual([0, 0]);
  expect(vi.mocked(classApi.exercise).mock.calls).toHaveLength(className === "" ? 0 : 1);
});

it.each([
  [`#exercise=${NAME}&class=6a`, "This link is for 6a, and this is 5b."],
  ["#exercise=none.exercise.xml", "The exercise of this link is not here: none.exercise.xml"],
  ["#exercise=broken", "The exercise of this link is not here: broken"],
])("%s opens nothing, and says why", async (hash, said) => {
  expect(await follow(hash)).toBe(said);
  expect(openWork).not.toHaveBeenCalled();
  expect(useStudio.getState().file.name).toBe("other.krt");
  expect(window.location.hash).toBe("");
});

it.each(["", "#mission=abc", "#exercise=", `#exercise=${"x".repeat(1001)}`])("%s is no such link", async (hash) => {
  expect(await follow(hash)).toBeUndefined();
  expect(works).not.toHaveBeenCalled();
});
