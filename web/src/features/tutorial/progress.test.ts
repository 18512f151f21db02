import { describe, expect, it } from "vitest";

import type { Tutorial, TutorialStep } from "../../api/generated";
import { begun, doneSteps, nextStep, readProgress } from "./progress";

const step = (asks: boolean, ...events: string[]): TutorialStep => ({
  label: {},
  help: {},
  hint: {},
  points: [],
  asks,
  events,
});
const tutorial: Tutorial = {
  name: "x",
  start: "x.krt",
  label: {},
  help: {},
  icon: "",
  order: 1000,
  teacher: null,
  problems: [],
  steps: [step(true), step(true, "run-done"), step(false)],
};

describe("what is done", () => {
  it("follows the program where only the program is asked for, and never forgets what happened", () => {
    const progress = { ...begun("x.krt"), happened: [1] };
    expect(doneSteps(tutorial, [true, true, true], progress)).toEqual([true, true, false]);
    expect(doneSteps(tutorial, [false, false, true], progress)).toEqual([false, true, false]);
    expect(doneSteps(tutorial, [], begun("x.krt"))).toEqual([false, false, false]);
  });

  it("takes a run only with the event, and a text only when it was gone on from", () => {
    expect(doneSteps(tutorial, [true, true, true], begun("x.krt"))).toEqual([true, false, false]);
    expect(doneSteps(tutorial, [], { ...begun("x.krt"), happened: [2] })).toEqual([false, false, true]);
  });
});

describe("where to go on", () => {
  it("is the next open step, then one before, then the end", () => {
    expect(nextStep([true, true, false, false], [], 0)).toBe(2);
    expect(nextStep([false, true, true, true], [], 3)).toBe(0);
    expect(nextStep([true, true], [], 1)).toBe(2);
  });

  it("leaves out what was skipped", () => {
    expect(nextStep([true, false, false], [1], 0)).toBe(2);
    expect(nextStep([true, false, true], [1], 2)).toBe(3);
  });
});

describe("what was remembered", () => {
  it("comes back as it was", () => {
    const progress = { at: 2, happened: [1], skipped: [0], path: "mine.krt" };
    expect(readProgress(JSON.stringify(progress), 3)).toEqual(progress);
  });

  it.each(["", "{", "null", "7", "[]", '{"at":"1","path":"x"}', '{"at":0.5,"path":"x"}', '{"at":1}'])(
    "makes nothing of %j",
    (text) => {
      expect(readProgress(text, 3)).toBeNull();
    },
  );

  it("is cut to the steps that there are now", () => {
    const text = JSON.stringify({ at: 9, happened: [1, 1, 7, -1, "2", null], skipped: {}, path: "" });
    expect(readProgress(text, 3)).toEqual({ at: 3, happened: [1], skipped: [], path: "" });
  });
});
