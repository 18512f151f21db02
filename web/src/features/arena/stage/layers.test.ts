import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { fitBox } from "../../../components/scene/camera";
import type { Actor, Scene, Seen } from "../../../components/scene/scene";
import { useStudio } from "../../../model/studio";
import type { Robot } from "../../../model/types";
import { useRun } from "../../../session/run";
import { recordingBrush } from "../../../testing/recording-pen";
import { Confetti } from "./confetti";
import { StageLayers } from "./layers";
import { readSwitches } from "./switches";

const ROOM = { width: 500, height: 400 };
const CAMERA = fitBox({ left: 0, right: 500, bottom: 0, top: 400 }, ROOM, 0);
/** Trails lie on a canvas of their own, which jsdom has not. */
const QUIET = '{"trails":false}';
const NOTHING = { label: {}, help: {}, icon: "", methods: [], initial: 0, shared: false };

const ray = { reach_mm: 1000, angle_rad: 0 };
const EYE = { name: "Eye", category: "sensor", type: "integer", min: 0, max: 100, ray, ...NOTHING } as const;
const ROBOT: Robot = { name: "rover", label: {}, help: {}, tick_ms: 20, wait_unit_ms: 100, objects: [EYE] };

function seenAt(name: string, y_mm: number): Seen {
  const actor = { name, role: "robot", length_mm: 100, face: {}, lid: 0 } as unknown as Actor;
  return { actor, pose: { x_mm: 50, y_mm, heading_rad: 0, load: 0, flags: 0 } } as Seen;
}

/** A run of robots that stand in a column, each with what its eye reads. */
function running(eyes: Record<string, number>): Seen[] {
  const agents = Object.entries(eyes).map(([name, eye], at) => ({
    ...{ name, program: "p", robot: "rover", number: at + 1, kind: "robot", active: [], state: "running" as const },
    ...{ inputs: { Eye: eye }, values: {}, fault: 0, forced: [], shown: {}, placed: true },
  }));
  useRun.setState({ agents, status: "running" });
  return agents.map(({ name }, at) => seenAt(name, 300 - 100 * at));
}

function drawn(seen: Seen[], selected: string, shows: string) {
  const recording = recordingBrush(CAMERA, ROOM);
  const scene = { running: true, real: false, actors: seen.map(({ actor }) => actor), world: {} } as unknown as Scene;
  const layers = new StageLayers(() => undefined);
  layers.show(readSwitches(shows), selected, false);
  layers.ground(recording.brush, scene, seen);
  layers.under(recording.brush, scene, seen);
  layers.over(recording.brush, scene, seen);
  return recording;
}

let before: ReturnType<typeof useStudio.getState>["catalogue"];
beforeEach(() => {
  before = useStudio.getState().catalogue;
  useStudio.setState({ catalogue: { ...before, robots: [ROBOT] } });
});
afterEach(() => {
  useStudio.setState({ catalogue: before });
  useRun.getState().reset();
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

const lines = ({ asked }: ReturnType<typeof recordingBrush>) =>
  asked.filter(({ path }) => path[0]?.[0] === "moveTo").map(({ path, width }) => [...path.flat(), width]);

test("a ray goes from the edge of the robot as far as its sensor reads, with a ring and its length where it ends", () => {
  const recording = drawn(running({ a: 20 }), "", QUIET);
  expect(lines(recording)).toEqual([["moveTo", 100, 100, "lineTo", 300, 100, 2]]);
  const rings = recording.asked.filter(({ path }) => path[0]?.[0] === "arc" && path[0][1] === 300);
  expect(rings.map(({ what }) => what)).toEqual(["stroke", "fill"]);
  expect(recording.words).toEqual(["20 cm"]);
});

test("a ray that meets nothing has neither, and of several robots only the one that is watched says its length", () => {
  expect(drawn(running({ a: 100 }), "", QUIET).words).toEqual([]);
  const two = drawn(running({ a: 20, b: 10 }), "b", QUIET);
  expect(lines(two)).toEqual([
    ["moveTo", 100, 100, "lineTo", 300, 100, 1.25],
    ["moveTo", 100, 200, "lineTo", 200, 200, 2],
  ]);
  expect(two.words).toEqual(["10 cm"]);
});

test("rays that are switched off are not drawn", () => {
  expect(lines(drawn(running({ a: 20 }), "", '{"trails":false,"rays":false}'))).toEqual([]);
});

const reduced = (matches: boolean) => vi.stubGlobal("matchMedia", () => ({ matches }));

test("confetti are 20 pieces that fall for 900 ms, lie until they are taken away, and are none for who wants no motion", () => {
  const again = vi.fn();
  const confetti = new Confetti(again);
  const now = vi.spyOn(performance, "now").mockReturnValue(1000);
  const heights = () => {
    const { brush, asked } = recordingBrush(CAMERA, ROOM);
    const falls = confetti.draw(brush);
    const fills = asked.filter(({ what }) => what === "fill");
    return { falls, y: fills.map(({ path }) => path.find(([step]) => step === "translate")?.[2] ?? -1) };
  };
  reduced(true);
  confetti.begin();
  expect(heights()).toEqual({ falls: false, y: [] });
  reduced(false);
  confetti.begin();
  expect(again).toHaveBeenCalledOnce();
  expect(heights()).toEqual({ falls: true, y: Array.from({ length: 20 }, () => 0) });
  now.mockReturnValue(1450);
  const half = heights();
  now.mockReturnValue(1900);
  const end = heights();
  expect([half.falls, end.falls]).toEqual([true, false]);
  expect(end.y.every((y, at) => y > (half.y[at] ?? y) && y <= ROOM.height)).toBe(true);
  now.mockReturnValue(60_000);
  expect(heights()).toEqual(end);
  confetti.clear();
  expect(heights().y).toEqual([]);
});
