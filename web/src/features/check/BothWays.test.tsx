/** Both ways over the room of the page: played in step as runs, as states of the model, or one of each; keys and focus. */
import { act, createElement } from "react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";

import type { CheckedProperty, RunStretch } from "../../api/generated";
import { stretchApi, type WantedStretch } from "../../api/run-stretch";
import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { growProgram, missionOf } from "../../model/testing/missions";
import { drawnWorld } from "../../model/world/drawing";
import { useRun } from "../../session/run";
import { barriersIn } from "../../testing/barriers";
import { mount, type Mounted, settle } from "../../testing/hooks";
import { spanOf } from "./both-ways";
import { BrokenRun } from "./BrokenRun";
import { begin, useCheck } from "./check-session";
import { answeredWith, BROKEN, CONFIRMED, KEPT, scene, WHY, WORLD } from "./testing/broken-property";

const recorded = vi.spyOn(stretchApi, "record");
let page: Mounted;

/** A stretch with a frame each fiftieth of a second, in which something happens after a second and a half. */
function stretch({ first, last, mission }: WantedStretch): RunStretch {
  const way = (frame: number) => [frame, 0, 0, 0, 0];
  const frames = last - first + 1;
  return {
    run: {
      ...{ program: null, world: drawnWorld(WORLD), seconds: last / 50, frames, shown: [], stock: [] },
      ...{ things: [], pens: [], marks: [] },
      agents: [{ name: "a", program: "p", robot: "mini-robot", number: 1, start: "" }],
      ways: [Array.from({ length: frames }, (_, frame) => way(frame)).flat()],
    },
    frame_s: 0.02,
    events:
      mission.failures === undefined
        ? [{ seconds: 1.1, kind: "load", agent: "a", text: "reaches in" }]
        : [
            { seconds: 1.1, kind: "unload", agent: "a", text: "goes on" },
            { seconds: 1.1, kind: "message", agent: "a", text: "Run = 1" },
            { seconds: 1.2, kind: "revival", agent: "a", text: "is well again" },
          ],
    ending: mission.failures === undefined ? "" : "All is done.",
  };
}

async function open(answer: CheckedProperty, mission = missionOf(growProgram(1, 3, true))): Promise<void> {
  useCheck.setState(answeredWith(answer, mission));
  useStudio.setState({ mission });
  page = mount(createElement(BrokenRun, { cell: { row: 0, column: 0 } }));
  find("check-other").focus();
  await settle(() => find("check-other").click());
}

const all = (name: string) => [...document.querySelectorAll<HTMLElement>(`[data-testid="${name}"]`)];
const find = (name: string) => all(name)[0] as HTMLElement;
const text = (name: string) => all(name)[0]?.textContent ?? "";
const at = () => Number(find("check-both").dataset["at"]);
const frames = () => ["broken", "kept"].map((name) => find(`check-way-${name}`).dataset["frame"]);
const press = (key: string, on = document.activeElement) =>
  act(() => void on?.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true })));
const BOTH: CheckedProperty = { ...BROKEN, why: { ...WHY, kept: KEPT } };

beforeEach(async () => {
  vi.stubGlobal(
    "ResizeObserver",
    class {
      observe = () => undefined;
      disconnect = () => undefined;
    },
  );
  vi.spyOn(HTMLCanvasElement.prototype, "getContext").mockReturnValue(null);
  Element.prototype.scrollIntoView = () => undefined;
  await moreWords();
  recorded.mockReset().mockImplementation((wanted) => Promise.resolve(stretch(wanted)));
  useStudio.setState({ world: drawnWorld(WORLD) });
});

afterEach(() => {
  page.end();
  useCheck.setState(useCheck.getInitialState());
  useRun.setState(useRun.getInitialState());
  vi.unstubAllGlobals();
  vi.useRealTimers();
});

test("both are runs of the simulator from a second before they part, in step by its time", async () => {
  await open(BOTH);
  expect(recorded.mock.calls.map(([wanted]) => [wanted.first, wanted.last, wanted.seed])).toEqual([
    [0, 100, 3],
    [0, 225, 3],
  ]);
  expect(recorded.mock.calls[1]?.[0].mission.failures).toEqual(KEPT.failures);
  expect(text("check-way-broken")).toContain("It breaks at 00:02.0");
  expect(text("check-way-kept")).toContain("All goes well");
  expect(text("check-way-kept")).toContain("a waits 0.5 s at 00:00.8.");
  expect([at(), ...frames()]).toEqual([0, "0", "0"]);
  expect(text("check-way-kept")).toContain("Up to here both are the same.");
  for (let step = 0; step < 6; step++) press("ArrowRight");
  expect(at()).toBeCloseTo(1.2);
  expect(frames()).toEqual(["60", "60"]);
  expect(text("check-way-broken")).toContain("a reaches in.");
  expect(text("check-way-kept")).toContain("a goes on.");
  press("End");
  expect(frames(), "the broken one stays where it broke").toEqual(["100", "225"]);
  expect(text("check-way-broken")).toContain("a waits for ever.");
  expect(text("check-way-kept")).toContain("All is done.");
  expect(text("check-both")).toContain("00:04.5");
});

test("it plays by itself at the speed that is chosen, and ends at its end", async () => {
  vi.useFakeTimers();
  await open(BOTH);
  act(() => find("check-steps-play").click());
  act(() => void vi.advanceTimersByTime(1000));
  expect(at()).toBeGreaterThan(0.8);
  expect(at()).toBeLessThan(1.1);
  act(() => find("check-steps-play").click());
  const stands = at();
  act(() => void vi.advanceTimersByTime(1000));
  expect(at()).toBe(stands);
  const speed = find("check-speed") as HTMLSelectElement;
  act(() => {
    speed.value = "4";
    speed.dispatchEvent(new Event("change", { bubbles: true }));
  });
  act(() => find("check-steps-play").click());
  act(() => void vi.advanceTimersByTime(2000));
  expect(at()).toBe(4.5);
  act(() => find("check-steps-play").click());
  expect(at(), "from the beginning again").toBe(0);
});

test("who wants less motion sees moments that are a second apart", async () => {
  vi.useFakeTimers();
  vi.stubGlobal("matchMedia", (media: string) => ({ matches: media.includes("reduced-motion"), media }));
  await open(BOTH);
  act(() => find("check-steps-play").click());
  act(() => void vi.advanceTimersByTime(1700));
  expect(at()).toBe(1);
});

test("where the simulator has no run that keeps it, its side shows states of the model, and says so", async () => {
  const other = { ...WHY.other!, scenes: [scene(1), scene(2), scene(4)] };
  await open({ ...BROKEN, why: { ...WHY, other } });
  expect(recorded).toHaveBeenCalledOnce();
  expect(find("check-way-broken").dataset["frame"]).toBe("0");
  expect(find("check-way-kept").dataset["frame"]).toBeUndefined();
  expect(text("check-way-kept")).toContain("these are states of the model");
  expect(find("check-way-kept").dataset["step"]).toBe("1");
  press("End");
  expect(find("check-way-kept").dataset["step"]).toBe("4");
});

test("where only the model breaks it, both are states of the model, in step", async () => {
  vi.useFakeTimers();
  const other = { ...WHY.other!, scenes: [scene(1), scene(2), scene(4)] };
  await open({ ...BROKEN, confirmed: null, why: { ...WHY, other } });
  expect(recorded).not.toHaveBeenCalled();
  const steps = () => ["check-both", "check-way-broken", "check-way-kept"].map((name) => find(name).dataset["step"]);
  expect(steps()).toEqual(["1", "1", "1"]);
  // The run alone lies behind it, with a bar of its own.
  act(() => find("check-both").querySelector<HTMLElement>('[data-testid="check-steps-play"]')?.click());
  act(() => void vi.advanceTimersByTime(800));
  expect(steps()).toEqual(["2", "2", "2"]);
  expect(text("check-way-kept")).toContain("b comes.");
  act(() => void vi.advanceTimersByTime(800));
  expect(steps()).toEqual(["4", "2", "4"]);
});

test("keys: the play button has the focus, Space and arrows work beside the buttons, and Escape gives the focus back", async () => {
  await open(BOTH);
  expect(document.activeElement).toBe(find("check-steps-play"));
  find("check-both").focus();
  press(" ");
  expect(find("check-steps-play").getAttribute("aria-label")).toBe("Pause");
  press(" ");
  press("End");
  press("ArrowLeft");
  expect(at()).toBeCloseTo(4.4);
  press("Home");
  expect(at()).toBe(0);
  expect(await barriersIn(find("check-both-ways"))).toEqual([]);
  press("Escape");
  expect(all("check-both-ways")).toHaveLength(0);
  expect(document.activeElement).toBe(find("check-other"));
});

test("what it covers is out of reach meanwhile", async () => {
  const main = document.createElement("main");
  const room = document.createElement("div");
  room.append(main);
  document.body.append(room);
  await open(BOTH);
  expect(room.contains(find("check-both-ways"))).toBe(true);
  expect(main.hasAttribute("inert")).toBe(true);
  press("Escape");
  expect(main.hasAttribute("inert")).toBe(false);
  room.remove();
});

test("an edit meanwhile is said, and both stay those of the mission that was checked", async () => {
  const mission = missionOf(growProgram(1, 3, true));
  await open(BOTH, mission);
  expect(text("check-both-ways")).not.toContain("has been changed since");
  act(() => useStudio.setState({ mission: { ...mission, label: { "": "other" } } }));
  expect(text("check-both-ways")).toContain("has been changed since");
  expect(recorded).toHaveBeenCalledTimes(2);
  expect(recorded.mock.calls[0]?.[0].mission).toBe(mission);
});

test("another check closes it", async () => {
  await open(BOTH);
  act(() => begin(0, ["fail"], 10, false));
  expect(all("check-both-ways")).toHaveLength(0);
});

test("a run that ends meanwhile changes nothing here", async () => {
  await open(BOTH);
  press("ArrowRight");
  act(() => useRun.setState({ status: "done", tick: 999 }));
  expect(at()).toBeCloseTo(0.2);
});

test("a refusal is said, and the states of the model are shown instead", async () => {
  recorded.mockReset().mockRejectedValue(new Error("The mission has 1 error."));
  await open(BOTH);
  expect(text("check-both-ways")).toContain("The mission has 1 error.");
  expect(find("check-way-broken").dataset["frame"]).toBeUndefined();
  expect(find("check-way-broken").dataset["step"]).toBe("1");
});

test("the span: without a known moment it begins some seconds before the break, and never before the first step", () => {
  const why = { ...WHY, tick: -1 };
  expect(spanOf({ confirmed: { ...CONFIRMED, tick: 600, seconds: 12 }, why })).toEqual({
    ...{ first: 200, parts: 200, brokenLast: 600, keptLast: null, tickS: 0.02 },
  });
  expect(spanOf({ confirmed: { ...CONFIRMED, tick: 0, seconds: 0 }, why })).toEqual({
    ...{ first: 0, parts: 0, brokenLast: 1, keptLast: null, tickS: 0.02 },
  });
  expect(spanOf({ confirmed: null, why })).toBeNull();
});
