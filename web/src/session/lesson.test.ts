/** The order of the path to learn, and where it goes on. */
import { describe, expect, it } from "vitest";

import { lesson } from "../testing/lessons";
import { inOrder, type Lesson, nextLesson, readLearned } from "./lesson";

const names = (lessons: readonly Lesson[]) => lessons.map(({ name }) => name);

describe("the path", () => {
  it("has what comes along first, then what the folder has, both by order, then by name", () => {
    const mixed = [lesson("b", 1000), lesson("a", 1000), lesson("mine", 0), lesson("example:z", 20)];
    const exercise = lesson("example:y", 10, { kind: "exercise" });
    expect(names(inOrder([...mixed, exercise]))).toEqual(["example:y", "example:z", "mine", "a", "b"]);
  });

  it("goes on with the next that is not learned, then with one before; what cannot be used is no step of it", () => {
    const path = [lesson("a", 1), lesson("b", 2), lesson("broken", 3, { usable: false }), lesson("c", 4)];
    const next = (learned: string[], after: string) => nextLesson(path, learned, after)?.name ?? null;
    expect([next([], ""), next(["a"], ""), next([], "a"), next(["a"], "a")]).toEqual(["a", "b", "b", "b"]);
    expect([next(["b"], "b"), next(["a", "b"], "b")]).toEqual(["c", "c"]);
    expect([next(["c"], "c"), next(["a", "c"], "c")]).toEqual(["a", "b"]);
    expect([next(["a", "b", "c"], "c"), next([], "another")]).toEqual([null, "a"]);
  });
});

describe("what was remembered", () => {
  it.each([
    [null, []],
    ['["a","b"]', ["a", "b"]],
    ['["a",7,null]', ["a"]],
    ["{", []],
    ['{"a":1}', []],
    ["7", []],
  ])("of %j is %j", (text, learned) => {
    expect(readLearned(text)).toEqual(learned);
  });
});
