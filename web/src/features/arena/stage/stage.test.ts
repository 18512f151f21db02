import { describe, expect, it } from "vitest";

import type { PoseFrame } from "../../../api/wire";
import type { Actor } from "../../../components/scene/scene";
import type { Robot } from "../../../model/types";
import { reachedGoal } from "./confetti";
import { causeOf } from "./EndCard";
import { changes } from "./gamepad";
import { LENGTHS_MS, notesOf } from "./melodies";
import { Motion } from "./motion";
import { raysOf } from "./rays";
import { soundOf } from "./sound";
import { readSwitches } from "./switches";
import { Trails } from "./trails";

const POSE = { x_mm: 0, y_mm: 0, heading_rad: 0, load: 0, flags: 0 };
const frame = (tick: number, ...places: [number, number][]): PoseFrame => ({
  tick,
  poses: places.map(([x_mm, y_mm]) => ({ ...POSE, x_mm, y_mm })),
});
const NOTHING = { label: {}, help: {}, icon: "", methods: [], initial: 0, shared: false };

describe("trails", () => {
  it("keep a place each 10 mm, of each robot its own", () => {
    const trails = new Trails();
    for (let tick = 0; tick <= 100; tick++) trails.record(frame(tick, [tick, 0], [0, 0]));
    expect(trails.lengths).toEqual([11, 1]);
  });

  it("lose what lay ahead when the run goes back", () => {
    const trails = new Trails();
    for (let tick = 0; tick <= 10; tick++) trails.record(frame(tick, [tick * 20, 0]));
    trails.record(frame(4, [80, 0]));
    expect(trails.lengths).toEqual([5]);
  });

  it("join no places that are far apart in time, but those of one that stood in between", () => {
    const trails = new Trails();
    trails.record(frame(0, [0, 0], [0, 0]));
    trails.record(frame(20, [100, 0], [0, 0]));
    trails.record(frame(40, [200, 0], [0, 0]));
    trails.record(frame(60, [300, 0], [50, 0]));
    expect(trails.apart).toEqual([0, 0]);
    trails.record(frame(200, [900, 400], [50, 0]));
    trails.record(frame(400, [100, 400], [50, 0]));
    trails.record(frame(410, [150, 400], [90, 0]));
    expect(trails.apart).toEqual([2, 0]);
    trails.record(frame(205, [910, 400], [50, 0]));
    expect(trails.apart).toEqual([1, 0]);
    // Back to a moment that nobody saw: no line leads there from the last place before it.
    trails.record(frame(150, [500, 300], [50, 0]));
    expect(trails.apart).toEqual([1, 0]);
    trails.record(frame(155, [520, 300], [50, 0]));
    expect(trails.apart).toEqual([1, 0]);
  });

  it("have no gap where the way between two frames came with the second", () => {
    const trails = new Trails();
    trails.record(frame(0, [0, 0]));
    for (const tick of [200, 400, 600]) trails.record(frame(tick, [tick, 0]), true);
    expect([trails.lengths, trails.apart]).toEqual([[4], [0]]);
  });

  it("stay bounded however long a run is", () => {
    const trails = new Trails();
    for (let tick = 0; tick < 12_000; tick++) trails.record(frame(tick, [(tick % 2) * 50, 0]));
    expect(trails.lengths[0]).toBeLessThanOrEqual(5000);
    expect(trails.lengths[0]).toBeGreaterThanOrEqual(4000);
  });
});

describe("the way ahead", () => {
  it("goes on as the robot does, in a curve where it turns, and is none for one that stands", () => {
    const motion = new Motion();
    motion.record(frame(0, [0, 0], [5, 5]));
    motion.record(frame(10, [100, 0], [5, 5]));
    const way = motion.ahead(0, { ...POSE, x_mm: 100 }, 20);
    expect(way.at(-1)?.[0]).toBeCloseTo(300);
    expect(motion.ahead(1, POSE, 20)).toEqual([]);
    motion.record({ tick: 20, poses: [{ ...POSE, x_mm: 200, heading_rad: 0.1 }] });
    expect(motion.ahead(0, POSE, 20).at(-1)?.[1]).toBeGreaterThan(10);
  });

  it("is none right after a run went back", () => {
    const motion = new Motion();
    motion.record(frame(10, [100, 0]));
    motion.record(frame(5, [50, 0]));
    expect(motion.ahead(0, POSE, 20)).toEqual([]);
  });
});

describe("a ray", () => {
  const ray = { reach_mm: 1000, angle_rad: Math.PI / 2 };
  const eye = { name: "Eye", category: "sensor", type: "integer", min: 0, max: 100, ray, ...NOTHING } as const;
  const robot: Robot = { name: "r", label: {}, help: {}, tick_ms: 20, wait_unit_ms: 100, objects: [eye] };
  const seen = { actor: { length_mm: 100 } as Actor, pose: { ...POSE, x_mm: 10 } };

  it("begins at the robot's edge, looks where the sensor does, and is as long as it reads", () => {
    const [found] = raysOf(robot, { Eye: 35 }, seen);
    expect(found?.from.map(Math.round)).toEqual([10, 50]);
    expect(found?.to.map(Math.round)).toEqual([10, 400]);
    expect([found?.mm, found?.ends]).toEqual([350, true]);
  });

  it("ends nowhere where nothing is seen, and whatever a recording says stays in its reach", () => {
    expect(raysOf(robot, { Eye: 100 }, seen)[0]?.ends).toBe(false);
    expect(raysOf(robot, { Eye: 5e9 }, seen)[0]?.mm).toBe(1000);
    expect(raysOf(robot, {}, seen)).toEqual([]);
    expect(raysOf(undefined, { Eye: 1 }, seen)).toEqual([]);
  });
});

describe("sound", () => {
  const buzzer = {
    name: "Music",
    category: "actuator",
    type: "integer",
    min: 0,
    max: 1,
    look: "melody",
    ...NOTHING,
  } as const;
  const bell = { ...buzzer, name: "Bell", look: "sound" } as const;
  const robot: Robot = { name: "r", label: {}, help: {}, tick_ms: 20, wait_unit_ms: 100, objects: [buzzer, bell] };

  it("is the tone, the melody or the horn of a robot, and nothing that nobody can hear", () => {
    expect(soundOf(robot, { Music: [440, 0] })).toBe("tone 440");
    expect(soundOf(robot, { Music: [0, 3] })).toBe("melody 2");
    expect(soundOf(robot, { Bell: [1] })).toBe("horn");
    for (const hz of [0, 3, 1e9, -5]) expect(soundOf(robot, { Music: [hz, 0] })).toBe("");
    expect(soundOf(undefined, {})).toBe("");
  });

  it("of a melody is as long as the simulator says; a number without one is the last", () => {
    LENGTHS_MS.forEach((ms, melody) => {
      const notes = notesOf(melody);
      expect(notes.reduce((sum, note) => sum + note.ms, 0)).toBeCloseTo(ms);
      expect(notes.every(({ hz }) => hz === 0 || (hz > 100 && hz < 2000))).toBe(true);
    });
    expect(notesOf(0)[0]?.hz).toBeCloseTo(261.63, 1);
    expect(notesOf(99)).toEqual(notesOf(11));
    expect(notesOf(-1)).toEqual(notesOf(0));
  });
});

describe("a gamepad", () => {
  const key = (sensor: string) => ({ sensor, label: sensor, letter: "", pressed: false, onBoard: true });
  const actor = { keys: [key("A"), key("B")], sliders: [{ sensor: "S", label: "S", value: 0, min: 0, max: 100 }] };
  const pad = (pressed: boolean[], ...axes: number[]) =>
    ({ axes, buttons: pressed.map((one) => ({ pressed: one })) }) as never;

  it("presses and lets go each key once, and sets a slider while its stick is held", () => {
    const first = changes(pad([true, false], 1), { down: [], set: [] }, actor);
    expect([first.press, first.release, first.slide]).toEqual([["A"], [], [["S", 100]]]);
    const second = changes(pad([true, true], 1), first, actor);
    expect([second.press, second.release, second.slide]).toEqual([["B"], [], []]);
    const third = changes(pad([], 0.01), second, actor);
    expect([third.press, third.release, third.slide]).toEqual([[], ["A", "B"], []]);
  });
});

describe("the end of a run", () => {
  const event = (tick: number, kind: string, text = kind) =>
    ({ tick, kind, agent: "r", text, cause: "world" }) as never;

  it("comes from the last thing that went wrong, else from the last that happened", () => {
    const events = [event(3, "load"), event(5, "collision"), event(7, "message"), event(9, "end")];
    expect(causeOf({ events, tick: 9 })?.tick).toBe(5);
    expect(causeOf({ events: [event(3, "load"), event(9, "end")], tick: 9 })?.tick).toBe(3);
    expect(causeOf({ events: [event(9, "end")], tick: 9 })).toBeNull();
  });

  it("is celebrated when a goal is reached, and not when a program is merely over", () => {
    expect(reachedGoal({ status: "done", mission: null, total: 12 })).toBe(true);
    expect(reachedGoal({ status: "done", mission: null, total: 0 })).toBe(false);
    expect(reachedGoal({ status: "stuck", mission: null, total: 12 })).toBe(false);
  });
});

describe("switches", () => {
  it("are remembered as far as that makes sense", () => {
    expect(readSwitches('{"trails":false,"nonsense":true,"rays":"yes"}')).toMatchObject({ trails: false, rays: true });
    for (const text of [null, "", "{", "7", "[]"]) expect(readSwitches(text).trails).toBe(true);
    expect(readSwitches('{"nonsense":true}')).not.toHaveProperty("nonsense");
  });
});
