/** Which lessons are learned, and where the path goes on from the one that is open. */
import { afterEach, expect, it } from "vitest";

import { lesson, setPath } from "../testing/lessons";
import { readLearned } from "./lesson";
import { nextOfOpen, openLesson, setOpenLesson, useLessons } from "./lessons";

let end: () => void = () => undefined;
afterEach(() => end());

const next = () => nextOfOpen(useLessons.getState())?.name ?? null;
const stored = () => readLearned(localStorage.getItem("kitrobot.learned"));

it("a lesson that is done is learned for good, once, and leads on; one that is not done leads nowhere", async () => {
  end = await setPath(lesson("b", 2), lesson("a", 1), lesson("c", 3));
  setOpenLesson("tutorial", { name: "a", done: false });
  expect([next(), stored()]).toEqual([null, []]);
  setOpenLesson("tutorial", { name: "a", done: true });
  expect([next(), stored()]).toEqual(["b", ["a"]]);
  // Undone again, it stays learned.
  setOpenLesson("tutorial", { name: "a", done: false });
  setOpenLesson("tutorial", { name: "a", done: true });
  expect(stored()).toEqual(["a"]);
  setOpenLesson("tutorial", null);
  expect([next(), stored(), openLesson(useLessons.getState())]).toEqual([null, ["a"], null]);
});

it("an exercise that begins before its tutorial is left is the one that is open", async () => {
  end = await setPath(lesson("a", 1), lesson("x", 2, { kind: "exercise" }), lesson("c", 3));
  setOpenLesson("tutorial", { name: "a", done: true });
  setOpenLesson("exercise", { name: "x", done: false });
  setOpenLesson("tutorial", null);
  expect(openLesson(useLessons.getState())?.name).toBe("x");
  setOpenLesson("exercise", { name: "x", done: true });
  expect(next()).toBe("c");
});
