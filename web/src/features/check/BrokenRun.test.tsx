/** Why a property broke: the sentences, the moment in the run, what plays from there, and the other way. */
import { act } from "react";
import { createRoot, type Root } from "react-dom/client";
import { afterEach, beforeEach, expect, test, vi } from "vitest";

import type { CheckedProperty, Scene, Why } from "../../api/generated";
import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { growProgram, missionOf } from "../../model/testing/missions";
import type { OwnWorld } from "../../model/types";
import { drawnWorld } from "../../model/world/drawing";
import { useRun } from "../../session/run";
import { BrokenRun } from "./BrokenRun";
import { plan } from "./table";
import { useCheck } from "./check-session";

(globalThis as { IS_REACT_ACT_ENVIRONMENT?: boolean }).IS_REACT_ACT_ENVIRONMENT = true;
const place = document.createElement("div");
let root: Root;

const scene = (step: number): Scene => ({ step, robots: [{ x_mm: step, y_mm: 0, heading_rad: 0, at: [] }] });
const NOTHING = { walls: [], floors: [], lines: [], roads: [], storehouses: [], docks: [], starts: [], zones: [] };
const WORLD: OwnWorld = {
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
const CONFIRMED = { seed: 3, tick: 100, seconds: 2, failures: [] };
const WHY: Why = {
  sentences: ["`a` waits for ever.", "This decides it: `a` stands.", "It does not break if `b` comes first."],
  certainty: "last",
  step: 1,
  left_out: 4,
  other: { events: [{ step: 1, text: "`b` comes." }], ends_well: true, scenes: [scene(1), scene(2)] },
  tick: 40,
  seconds: 0.8,
  without_failures: null,
};
const BROKEN: CheckedProperty = {
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

async function shown(answer: CheckedProperty): Promise<void> {
  await moreWords();
  useCheck.setState({
    asked: { mission: missionOf(growProgram(1, 3, true)), path: "", seed: 1, failures: 0, seconds: 60 },
    plan: plan(0),
    columns: [
      {
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
      },
    ],
  });
  act(() => root.render(<BrokenRun cell={{ row: 0, column: 0 }} />));
}

const all = (name: string) => [...place.querySelectorAll<HTMLElement>(`[data-testid="${name}"]`)];
const text = (name: string) => all(name)[0]?.textContent ?? "";
const press = (name: string) => act(() => all(name)[0]?.click());

beforeEach(() => {
  Element.prototype.scrollIntoView = () => undefined;
  document.body.append(place);
  root = createRoot(place);
  useStudio.setState({ world: drawnWorld(WORLD) });
});

afterEach(() => {
  act(() => root.unmount());
  useCheck.setState(useCheck.getInitialState());
  useRun.setState(useRun.getInitialState());
  document.body.replaceChildren();
  vi.restoreAllMocks();
});

test("three sentences say why, and the deciding event is marked in the run", async () => {
  await shown(BROKEN);
  expect(text("check-why")).toContain("This decides it: a stands.");
  expect(all("check-why")[0]?.querySelectorAll("li")).toHaveLength(3);
  expect(text("check-why")).toContain("4 events were left out");
  const marked = [...place.querySelectorAll('[data-decided="true"]')].map((one) => one.textContent);
  expect(marked).toEqual(["2a stands.This decides it"]);
});

test("the run of the simulator is played from the moment that decided it", async () => {
  const start = vi.fn();
  useRun.setState({ start });
  await shown(BROKEN);
  press("check-play-moment");
  expect(useCheck.getState().played).toEqual({ ...CONFIRMED, tick: 40, seconds: 0.8 });
  expect(start).toHaveBeenCalledOnce();
  expect(all("check-play-kept")).toHaveLength(0);
});

test("without the failure it is played up to where that would have come", async () => {
  const kept = { seed: 3, tick: 41, seconds: 0.82, failures: [] };
  useRun.setState({ start: vi.fn() });
  await shown({ ...BROKEN, why: { ...WHY, without_failures: kept } });
  press("check-play-kept");
  expect(useCheck.getState().played).toEqual(kept);
});

test("a moment that the simulator does not tell has no button", async () => {
  await shown({ ...BROKEN, why: { ...WHY, tick: -1 } });
  expect(all("check-play-moment")).toHaveLength(0);
});

test("both ways are played side by side, in step, from the moment that decided on, and close again", async () => {
  vi.useFakeTimers();
  const other = { ...WHY.other!, scenes: [scene(1), scene(2), scene(4)] };
  await shown({ ...BROKEN, why: { ...WHY, other } });
  const at = () => ["check-both", "check-way-broken", "check-way-kept"].map((name) => all(name)[0]?.dataset["step"]);
  expect(all("check-both")).toHaveLength(0);
  press("check-other");
  expect(at()).toEqual(["1", "1", "1"]);
  expect(text("check-way-kept")).toContain("All goes well");
  press("check-steps-play");
  act(() => void vi.advanceTimersByTime(700));
  expect(at()).toEqual(["2", "2", "2"]);
  expect(text("check-way-broken")).toContain("a stands.");
  expect(text("check-way-kept")).toContain("b comes.");
  act(() => void vi.advanceTimersByTime(700));
  expect(at()).toEqual(["4", "2", "4"]);
  press("check-other");
  expect(all("check-both")).toHaveLength(0);
  vi.useRealTimers();
});

test("a run that only the model has seen goes to the deciding step", async () => {
  await shown({ ...BROKEN, confirmed: null });
  expect(all("check-steps")[0]?.dataset["step"]).toBe("0");
  press("check-to-moment");
  expect(all("check-steps")[0]?.dataset["step"]).toBe("1");
});

test("before it is known why, nothing is said of it", async () => {
  await shown({ ...BROKEN, why: null });
  expect(all("check-why")).toHaveLength(0);
  expect(place.querySelectorAll("[data-decided]")).toHaveLength(0);
});
