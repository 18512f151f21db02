import { beforeEach, describe, expect, it, vi } from "vitest";

import type { Robot, RobotObject } from "../../model/types";
import { type RunAgent, useRun } from "../../session/run";
import { faceOf, indicatorsOf, keysOf, letterOf, lightsOf, slidersOf } from "./boards";
import { boardUnit, keyAt } from "./draw-board";
import { isHeld, press, release, releaseAll, useHands } from "./hands";
import type { Actor, Seen } from "./scene";

function part(name: string, category: RobotObject["category"], seen: Partial<Pick<RobotObject, "look" | "hand">>) {
  const nothing = { icon: "", label: {}, help: {}, methods: [], min: 0, max: 1, initial: 0, shared: false };
  const part: RobotObject = { name, category, type: "integer", look: "", hand: "", ...seen, ...nothing };
  return part;
}

const BOARD: Robot = {
  name: "board",
  label: {},
  help: {},
  tick_ms: 40,
  wait_unit_ms: 100,
  objects: [
    part("Display", "actuator", { look: "lights" }),
    part("Music", "actuator", { look: "melody" }),
    part("P0", "actuator", { look: "pin" }),
    part("P1", "actuator", { look: "pin" }),
    part("ButtonA", "sensor", { hand: "button" }),
    part("ButtonB", "sensor", { hand: "button" }),
    part("Shake", "sensor", { hand: "gesture" }),
    part("Tilt", "sensor", {}),
  ],
};
const CAR: Robot = { ...BOARD, name: "car", objects: [part("Wheel", "actuator", { look: "wheels" })] };

describe("what a robot shows", () => {
  it("is dark before a run, and what its display shows in one", () => {
    expect(faceOf(BOARD, {})).toEqual({ rows: [0, 0, 0, 0, 0], sounds: false, pins: [0, 0] });
    const shown = { Display: [9090, 0, 12345, 0, 0], Music: [0, 3], P0: [2, 1023], P1: [3, 90] };
    expect(faceOf(BOARD, shown)).toEqual({ rows: shown.Display, sounds: true, pins: [1, 0.5] });
    expect(lightsOf(9090)).toEqual([0, 9, 0, 9, 0]);
    expect(lightsOf(12345)).toEqual([1, 2, 3, 4, 5]);
  });

  it("is nothing for what drives, and for a robot that nobody knows", () => {
    expect(faceOf(CAR, {})).toBeNull();
    expect(faceOf(undefined, {})).toBeNull();
    expect(keysOf(CAR, {})).toEqual([]);
  });

  it("has keys with a letter each, pressed as the sensor says", () => {
    const keys = keysOf(BOARD, { ButtonB: 1 });
    expect(keys.map(({ sensor, letter, pressed, onBoard }) => [sensor, letter, pressed, onBoard])).toEqual([
      ["ButtonA", "A", false, true],
      ["ButtonB", "B", true, true],
      ["Shake", "S", false, false],
    ]);
  });

  it.each([
    ["ButtonA", "A"],
    ["Shake", "S"],
    ["key", "K"],
    ["ABC", "A"],
    ["", ""],
  ])("reads the letter of %s as %s", (name, letter) => expect(letterOf(name)).toBe(letter));
});

describe("devices of one's own", () => {
  const show = { name: "Show", kind: "procedure" as const, label: {}, help: {}, icon: "", completes_later: false };
  const from = (min: number, max: number) => ({
    ...{ ...show, stop: null, phrase: {} },
    parameters: [{ name: "value", kind: "integer" as const, min, max, default: 0, unit: "", label: {}, help: {} }],
  });
  const robot: Robot = {
    ...BOARD,
    name: "own",
    objects: [
      { ...part("Pump", "actuator", { look: "bar" }), methods: [from(0, 50)] },
      { ...part("Gauge", "actuator", { look: "number" }), methods: [from(-100, 100)] },
      {
        ...part("Bell", "actuator", { look: "sound" }),
        methods: [{ ...show, stop: null, phrase: {}, parameters: [] }],
      },
      { ...part("Soil", "sensor", { hand: "slider" }), min: 10, max: 90, initial: 70 },
    ],
  };

  it("are shown by their value, between nothing and their largest", () => {
    const shown = { Pump: [25], Gauge: [0], Bell: [1] };
    expect(indicatorsOf(robot, shown).map(({ label, look, value, share }) => [label, look, value, share])).toEqual([
      ["Pump", "bar", 25, 0.5],
      ["Gauge", "number", 0, 0.5],
      ["Bell", "sound", 1, 1],
    ]);
    expect(indicatorsOf(robot, {}).map(({ value }) => value)).toEqual([0, 0, 0]);
    expect(indicatorsOf(undefined, {})).toEqual([]);
  });

  it("are set by sliders, which stand at their initial number before a run", () => {
    expect(slidersOf(robot, {})).toEqual([{ sensor: "Soil", label: "Soil", value: 70, min: 10, max: 90 }]);
    expect(slidersOf(robot, { Soil: 33 })[0]?.value).toBe(33);
    expect(slidersOf(CAR, {})).toEqual([]);
  });
});

describe("a button of a board", () => {
  const seen = (heading_rad: number): Seen => {
    const face = faceOf(BOARD, {});
    const pose = { x_mm: 100, y_mm: 50, heading_rad, load: 0, flags: 0 };
    const actor: Actor = {
      ...{
        name: "b",
        program: "p",
        number: 1,
        role: "robot",
        length_mm: 135,
        free: true,
        start: pose,
        senses: [],
        failed: false,
      },
      ...{ figure: "micro-bit", lid: 0, face, keys: keysOf(BOARD, {}), sliders: [], indicators: [] },
    };
    return { actor, pose, failed: false, stalled: false, muted: false, collided: false };
  };
  const brush = { camera: { scale: 2, x: 0, y: 200 }, unit: 2 };

  it("is where it is drawn, on the left and on the right", () => {
    // The board's middle is at 200, 100 on the screen.
    expect(keyAt(brush, [seen(0)], 200 - 48, 92)).toEqual({ agent: "b", sensor: "ButtonA" });
    expect(keyAt(brush, [seen(0)], 200 + 48, 92)).toEqual({ agent: "b", sensor: "ButtonB" });
    expect(keyAt(brush, [seen(0)], 200, 92)).toBeNull();
  });

  it("is above the lights where it is the third, a logo", () => {
    const one = seen(0);
    const keys = keysOf({ ...BOARD, objects: [...BOARD.objects, part("Logo", "sensor", { hand: "button" })] }, {});
    expect(keys.map(({ letter }) => letter)).toEqual(["A", "B", "S", "L"]);
    const v2 = { ...one, actor: { ...one.actor, keys } };
    expect(keyAt(brush, [v2], 200, 100 - 44)).toEqual({ agent: "b", sensor: "Logo" });
    expect(keyAt(brush, [v2], 200 - 48, 92)).toEqual({ agent: "b", sensor: "ButtonA" });
    expect(keyAt(brush, [v2], 200, 92)).toBeNull();
    expect(keyAt(brush, [one], 200, 100 - 44)).toBeNull();
  });

  it("turns with the board", () => {
    // Counter-clockwise by a quarter: what was on the left is below.
    expect(keyAt(brush, [seen(Math.PI / 2)], 192, 100 + 48)).toEqual({ agent: "b", sensor: "ButtonA" });
    expect(keyAt(brush, [seen(Math.PI / 2)], 200 - 48, 92)).toBeNull();
  });

  it("is large enough to be seen while there are few boards", () => {
    expect(boardUnit(0.5, 1) * 64).toBe(150);
    expect(boardUnit(5, 1)).toBe(5);
    expect(boardUnit(0.5, 40)).toBe(0.5);
  });
});

describe("a hand on a key", () => {
  const force = vi.fn();
  const feels = (inputs: Record<string, number>): { agents: RunAgent[] } => {
    const started = { name: "b", program: "p", robot: "board", number: 1, kind: "robot", placed: true };
    return {
      agents: [{ ...started, active: [], state: "waiting", values: {}, inputs, shown: {}, fault: 0, forced: [] }],
    };
  };
  beforeEach(() => {
    force.mockClear();
    useHands.setState({ held: [] });
    useRun.setState({ status: "running", name: "r", tick: 10, abilities: ["force"], force, ...feels({}) });
  });
  const held = () => useHands.getState().held;

  it("forces the sensor while it is held, and gives it back", () => {
    expect(press("b", "A")).toBe(true);
    expect(force.mock.calls).toEqual([["b", "A", 1]]);
    useRun.setState({ tick: 50, ...feels({ A: 1 }) });
    expect(isHeld(held(), "b", "A")).toBe(true);
    release("b", "A");
    expect(force.mock.calls.slice(1)).toEqual([["b", "A", null]]);
    expect(held()).toEqual([]);
  });

  it("holds a short press until the program has felt it", () => {
    press("b", "A");
    release("b", "A");
    useRun.setState({ tick: 60 });
    expect(force).toHaveBeenCalledTimes(1);
    expect(isHeld(held(), "b", "A")).toBe(true);
    useRun.setState(feels({ A: 1 }));
    expect(force.mock.calls.slice(1)).toEqual([["b", "A", null]]);
  });

  it("does not wait for ever for a program that feels nothing any more", () => {
    press("b", "A");
    release("b", "A");
    useRun.setState({ tick: 261 });
    expect(force.mock.calls.slice(1)).toEqual([["b", "A", null]]);
  });

  it("holds on when it presses again before that", () => {
    press("b", "A");
    release("b", "A");
    press("b", "A");
    useRun.setState(feels({ A: 1 }));
    expect(force.mock.calls).toEqual([["b", "A", 1]]);
  });

  it("lets go of everything at once", () => {
    press("b", "A");
    press("b", "B");
    useRun.setState(feels({ A: 1, B: 1 }));
    releaseAll();
    expect(force.mock.calls.slice(2)).toEqual([
      ["b", "A", null],
      ["b", "B", null],
    ]);
  });

  it("can do nothing to a recording, to a run of somebody else, to one that is over, and without one", () => {
    const states = [{ abilities: [] }, { status: "idle" as const }, { status: "done" as const }];
    for (const state of states) {
      useRun.setState({ status: "running", abilities: ["force"], ...state });
      expect(press("b", "A")).toBe(false);
    }
    expect(force).not.toHaveBeenCalled();
  });

  it.each([{ name: "another", tick: 0 }, { status: "done" as const }])("is forgotten when the run is over", (state) => {
    press("b", "A");
    useRun.setState(state);
    expect(held()).toEqual([]);
    release("b", "A");
    expect(force).toHaveBeenCalledTimes(1);
  });
});
