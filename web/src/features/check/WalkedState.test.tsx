/** A walk by hand: its steps as buttons, taken and taken back, and what the server refuses. */
import { createElement } from "react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { ApiError } from "../../api/client";
import type { StateWalk } from "../../api/generated";
import { walkApi } from "../../api/state-walk";
import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { useCounterexample } from "../../session/counterexample";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted } from "../../testing/hooks";
import { beginWalk, useStateWalk } from "./state-walk";
import { WalkedState } from "./WalkedState";

const STATE: StateWalk = {
  places: [],
  happened: [],
  situation: [],
  shared: ["A: 3", "Run = 1"],
  scene: { step: 0, robots: [{ x_mm: 10, y_mm: 10, heading_rad: 0, at: [["carrier", "v1"]] }] },
  possible: [
    { place: 0, sentences: ["`a` begins to roll"], is_failure: false, returns_to: -1, breaks: [] },
    { place: 1, sentences: ["`b` begins to roll"], is_failure: false, returns_to: 2, breaks: ["contact"] },
    { place: 2, sentences: ["`a` fails"], is_failure: true, returns_to: -1, breaks: [] },
  ],
  more: 0,
};

const answers = vi.spyOn(walkApi, "walk");
let page: Mounted;
let hands: Hands;

beforeEach(async () => {
  await moreWords();
  answers.mockReset().mockImplementation((wanted) =>
    Promise.resolve({
      ...STATE,
      places: wanted.places,
      happened: wanted.places.map(String),
      scene: { ...STATE.scene, step: wanted.places.length },
    }),
  );
  page = mount(createElement(WalkedState));
  hands = handsOn(page);
});

afterEach(() => {
  page.end();
  useStateWalk.setState(useStateWalk.getInitialState(), true);
});

async function walk(places: number[] = []): Promise<void> {
  beginWalk({ timing: "free", failures: 1 }, undefined, places);
  await vi.waitFor(() => expect(hands.has("walk-state")).toBe(true));
}

const step = () => hands.find("walk-state").dataset["step"];
const isOff = (testId: string) => hands.find<HTMLButtonElement>(testId).disabled;

test("each possible step is a button, failures apart, with what it breaks and where it leads back to", async () => {
  await walk();
  expect(hands.find("walk-step-0").textContent).toBe("a begins to roll");
  expect(hands.find("walk-step-1").textContent).toBe("b begins to rollbreaks contactback to state 2");
  const failures = hands.find("walk-step-2").closest("details");
  expect(failures?.querySelector("summary")?.textContent).toBe("1 failure");
  expect(hands.find("walk").textContent).toContain("A: 3 · Run = 1");
  expect(useCounterexample.getState().marks.map(({ program, vertex }) => [program, vertex])).toEqual([
    ["carrier", "v1"],
  ]);
});

test("a step is taken, taken back, and all of them are", async () => {
  await walk();
  hands.click("walk-step-1");
  await vi.waitFor(() => expect(step()).toBe("1"));
  hands.click("walk-step-0");
  await vi.waitFor(() => expect(step()).toBe("2"));
  expect(useStateWalk.getState().state?.places).toEqual([1, 0]);
  hands.click("walk-back");
  await vi.waitFor(() => expect(step()).toBe("1"));
  hands.click("walk-anew");
  await vi.waitFor(() => expect(step()).toBe("0"));
  expect(isOff("walk-back")).toBe(true);
});

test("where only one step is possible the walk goes on by itself, and nowhere else", async () => {
  await walk();
  expect(isOff("walk-on")).toBe(true);
  answers.mockResolvedValueOnce({ ...STATE, places: [0], possible: STATE.possible.slice(1) });
  hands.click("walk-step-0");
  await vi.waitFor(() => expect(isOff("walk-on")).toBe(false));
  hands.click("walk-on");
  expect(answers.mock.lastCall?.[0]).toMatchObject({ places: [0], goes_on: true });
});

test("another assumption begins anew with the mission as it was when the walk began", async () => {
  await walk([1, 1]);
  const { mission } = useStudio.getState();
  hands.choose("walk-timing", "lockstep");
  expect(answers.mock.lastCall?.[0]).toMatchObject({ timing: "lockstep", failures: 1, places: [], mission });
  await vi.waitFor(() => expect(step()).toBe("0"));
});

test("a mission that has no states is told in a sentence, and a close takes marks and steps away", async () => {
  answers.mockRejectedValueOnce(new ApiError("`a` drives a distance on a road.", "Let it drive on."));
  beginWalk({ timing: "free", failures: 0 });
  await vi.waitFor(() => expect(hands.find("refused").textContent).toContain("Let it drive on."));
  hands.click("walk-close");
  expect(hands.has("walk")).toBe(false);
  expect(useCounterexample.getState().marks).toEqual([]);
});

test("of two requests the later one counts, whichever is answered first", async () => {
  await walk();
  let answerLate: (state: StateWalk) => void = () => undefined;
  answers.mockImplementationOnce(() => new Promise((resolve) => (answerLate = resolve)));
  hands.click("walk-step-0");
  hands.choose("walk-failures", "0");
  await vi.waitFor(() => expect(useStateWalk.getState().busy).toBe(false));
  answerLate({ ...STATE, places: [0, 0, 0] });
  await Promise.resolve();
  expect(useStateWalk.getState().state?.places).toEqual([]);
});
