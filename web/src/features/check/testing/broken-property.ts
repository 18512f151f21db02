/** A property that is broken, as tests show it: its run, why, and another way. */
import type { CheckedProperty, KeptRun, Scene, VerifyColumnMessage, Why } from "../../../api/generated";
import { growProgram, missionOf } from "../../../model/testing/missions";
import type { OwnWorld } from "../../../model/types";
import { plan } from "../table";

export const scene = (step: number): Scene => ({ step, robots: [{ x_mm: step, y_mm: 0, heading_rad: 0, at: [] }] });
const NOTHING = { walls: [], floors: [], lines: [], roads: [], storehouses: [], docks: [], starts: [], zones: [] };
export const WORLD: OwnWorld = {
  ...NOTHING,
  name: "w",
  width_mm: 100,
  height_mm: 100,
  boxes: [],
  balls: [],
  unknown: [],
  label: {},
  help: {},
};
export const CONFIRMED = { seed: 3, tick: 100, seconds: 2, failures: [] };
export const WHY: Why = {
  sentences: ["`a` waits for ever.", "This decides it: `a` stands.", "It does not break if `b` comes first."],
  certainty: "last",
  step: 1,
  left_out: 4,
  other: { events: [{ step: 1, text: "`b` comes." }], ends_well: true, scenes: [scene(1), scene(2)] },
  tick: 40,
  seconds: 0.8,
  kept: null,
};
export const BROKEN: CheckedProperty = {
  name: "end",
  sentence: "in the end every program ends",
  answer: "broken",
  steps: 2,
  repeats_from: 2,
  events: [
    { step: 0, text: "`a` begins." },
    { step: 1, text: "`a` stands." },
    { step: 2, text: "`a` waits." },
  ],
  left_out: 0,
  confirmed: CONFIRMED,
  searched: true,
  scenes: [scene(0), scene(1), scene(2)],
  guilty: [],
  places: [],
  why: WHY,
};

/** A run of the simulator that keeps it: a robot waits. */
export const KEPT: KeptRun = {
  seed: 3,
  tick: 40,
  seconds: 0.8,
  failures: [
    { agent: "a", at_s: 0.8, kind: "stall" },
    { agent: "a", at_s: 1.3, kind: "revive" },
  ],
  delayed: "a",
  delay_s: 0.5,
  ends_well: true,
};

const columnOf = (answer: CheckedProperty): VerifyColumnMessage => ({
  type: "column",
  timing: "lockstep",
  failures: 0,
  states: 10,
  depth: 3,
  cut: null,
  seconds: 1,
  is_approximate: false,
  odds: null,
  properties: [answer],
});

/** The state of a check of a mission with that answer, whose run is open. */
export const answeredWith = (answer: CheckedProperty, mission = missionOf(growProgram(1, 3, true))) => ({
  asked: { mission, path: "", seed: 1, failures: 0, seconds: 60 },
  plan: plan(0),
  columns: [columnOf(answer)],
  open: { row: 0, column: 0 },
});
