import { beforeEach, describe, expect, it } from "vitest";

import type { Tutorial, TutorialStep } from "../../api/generated";
import { begun, rememberedProgress } from "./progress";
import { enter, goBack, goForward, goTo, heardEvent, heardFits, leave, movedTo, showHint, useTutorial } from "./state";
import { eventsOf } from "./step-watch";

const step = (asks: boolean, ...events: string[]): TutorialStep => ({
  label: {},
  help: {},
  hint: {},
  points: [],
  asks,
  events,
});
const tutorial: Tutorial = {
  name: "t",
  start: "t.krt",
  label: {},
  help: {},
  icon: "",
  order: 1000,
  teacher: null,
  problems: [],
  steps: [step(true), step(true), step(true, "run-done"), step(false)],
};
const at = () => useTutorial.getState().progress.at;

beforeEach(() => {
  localStorage.clear();
  enter(tutorial, begun("t.krt"));
});

describe("going on", () => {
  it("happens once, when the step becomes done", () => {
    heardFits([false, false, false, true]);
    expect(at()).toBe(0);
    heardFits([true, false, false, true]);
    expect(at()).toBe(1);
    expect(useTutorial.getState().last).toBe(0);
  });

  it("jumps over what was done before its time", () => {
    heardFits([false, true, false, true]);
    heardFits([true, true, true, true]);
    expect(at()).toBe(2);
  });

  it("leaves a person alone who went back to a done step, until it is undone and done again", () => {
    heardFits([true, false, false, true]);
    goBack();
    expect(at()).toBe(0);
    heardFits([true, false, false, true]);
    expect(at()).toBe(0);
    heardFits([false, false, false, true]);
    heardFits([true, false, false, true]);
    expect(at()).toBe(1);
  });

  it("shows an undone step as open without moving away from where somebody is", () => {
    heardFits([true, false, false, true]);
    heardFits([false, false, false, true]);
    expect(at()).toBe(1);
    heardFits([false, true, false, true]);
    expect(at()).toBe(2);
  });

  it("wants the event while the program is right", () => {
    heardFits([true, true, false, true]);
    expect(at()).toBe(2);
    heardEvent("run-done", [true, true, false, true]);
    heardEvent("saved", [true, true, true, true]);
    expect(at()).toBe(2);
    heardEvent("run-done", [true, true, true, true]);
    expect(at()).toBe(3);
    heardFits([true, true, false, true]);
    expect(useTutorial.getState().progress.happened).toEqual([2]);
  });
});

describe("the buttons", () => {
  it("skip and remember it; a text that was read is done", () => {
    goForward();
    goForward();
    goForward();
    expect(useTutorial.getState().progress).toMatchObject({ at: 3, skipped: [0, 1, 2], happened: [] });
    goForward();
    expect(useTutorial.getState().progress).toMatchObject({ at: 4, skipped: [0, 1, 2], happened: [3] });
    goForward();
    expect(at()).toBe(4);
  });

  it("never lead out of the steps", () => {
    goBack();
    expect(at()).toBe(0);
    goTo(99);
    expect(at()).toBe(4);
  });

  it("show the hint of one step only", () => {
    showHint();
    expect(useTutorial.getState().hinted).toBe(true);
    goForward();
    expect(useTutorial.getState().hinted).toBe(false);
  });
});

it("what was done is there after leaving, with the file it was saved to", () => {
  heardFits([true, false, false, true]);
  movedTo("mine.krt");
  leave();
  expect(useTutorial.getState().tutorial).toBeNull();
  expect(rememberedProgress(tutorial)).toEqual({ at: 1, happened: [], skipped: [], path: "mine.krt" });
});

it("tells the events of a run from its status", () => {
  expect(eventsOf("running", "connecting")).toEqual(["run-started"]);
  expect(eventsOf("done", "running")).toEqual(["run-done", "run-ended"]);
  expect(eventsOf("stuck", "paused")).toEqual(["run-ended"]);
  expect(eventsOf("idle", "running")).toEqual([]);
  expect(eventsOf("paused", "running")).toEqual([]);
  expect(eventsOf("running", "paused")).toEqual([]);
  expect(eventsOf("done", "done")).toEqual([]);
});
