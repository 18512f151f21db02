import { beforeEach, describe, expect, it } from "vitest";

import type { StartedMessage } from "../api/generated";
import type { RunMessage } from "../api/wire";
import { isFromRecording, isRecording } from "./recordings";
import { applyMessage, canGoBack, isEnded, isLive, useRun } from "./run";
import { hasPlace } from "./saving";

const STARTED: StartedMessage = {
  type: "started",
  run: "run-7",
  tick_ms: 20,
  seed: 4,
  world: {
    name: "",
    width_mm: 1,
    height_mm: 1,
    walls: [],
    floors: [],
    lines: [],
    roads: [],
    docks: [],
    storehouses: [],
    starts: [],
  },
  agents: [],
  stock: {},
  total: 0,
  abilities: ["seek", "step"],
  recording: true,
  fail_rate: 0.25,
  fleet: false,
  watching: false,
  another: false,
  pens: [],
};

function hear(message: RunMessage): void {
  useRun.setState((state) => applyMessage(state, message));
}

beforeEach(() => {
  useRun.getState().reset();
});

describe("a recording", () => {
  it("is known by its ending, and its mission by where it is", () => {
    expect(["a.krtrace", "A.KRTRACE", "a.krt", "krtrace"].map(isRecording)).toEqual([true, true, false, false]);
    expect(["recording:ab/a.krt", "a.krt", ""].map(isFromRecording)).toEqual([true, false, false]);
  });

  it("has no file of its own, so saving its mission asks for a name", () => {
    expect(["recording:ab/a.krt", "example:a.krt", "", "a.krt"].map(hasPlace)).toEqual([false, false, false, true]);
  });

  it("is a run that says what it is, by which name it can be saved, and with which seed it was made", () => {
    hear(STARTED);
    const { recording, name, seed, failRate, status } = useRun.getState();
    expect([recording, name, seed, failRate, status]).toEqual([true, "run-7", 4, 0.25, "running"]);
    useRun.getState().reset();
    expect([useRun.getState().recording, useRun.getState().name]).toEqual([false, ""]);
  });

  it("of real robots leaves the seed of the next run as it was", () => {
    useRun.setState({ seed: 5 });
    const robot = { name: "micro:bit", program: "p", robot: "microbit", number: 1, kind: "robot", placed: false };
    hear({ ...STARTED, seed: 0, agents: [robot] });
    expect(useRun.getState().seed).toBe(5);
    hear({ ...STARTED, seed: 4, agents: [{ ...robot, placed: true }] });
    expect(useRun.getState().seed).toBe(4);
  });

  it("that ends while its run was on can be gone back in", () => {
    hear(STARTED);
    hear({ type: "state", status: "end", tick: 9, seconds: 0.18, sentence: "It ends here.", hits: [], problems: [] });
    const { status } = useRun.getState();
    expect([isLive(status), isEnded(status), canGoBack(status)]).toEqual([false, true, true]);
  });
});
