/** What stands across the page beside a run: another window's, a recording, the past of real robots; and what can be pressed then. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { useDisk } from "../../session/disk";
import type { OpenRecording } from "../../session/recordings";
import { useRun } from "../../session/run";
import { chooseSimple } from "../../session/simple-view";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted, settle } from "../../testing/hooks";
import { Watching } from ".";
import { BehindBar } from "./BehindBar";
import { EventStrip } from "./EventStrip";
import { RecordingBar } from "./RecordingBar";
import { RunTools } from "./RunTools";

await moreWords();

const MISSION = missionOf(CARRIER);
let page: Mounted;
let hands: Hands;
const [watch, reset, replay, start, follow, seek] = [vi.fn(), vi.fn(), vi.fn(), vi.fn(), vi.fn(), vi.fn()];

beforeEach(() => {
  vi.clearAllMocks();
  vi.stubGlobal(
    "ResizeObserver",
    class {
      observe = vi.fn();
      disconnect = vi.fn();
    },
  );
  useStudio.getState().openMission(fileOf(MISSION));
  useDisk.setState(useDisk.getInitialState());
  useRun.setState({ ...useRun.getInitialState(), watch, reset, replay, start, follow, seek });
});
afterEach(() => {
  page.end();
  useDisk.setState(useDisk.getInitialState());
  useRun.setState(useRun.getInitialState());
  vi.unstubAllGlobals();
});

async function open(tree: React.JSX.Element): Promise<void> {
  await settle(() => {
    page = mount(tree);
  });
  hands = handsOn(page);
}
const bar = () => hands.find("watching-bar");
const isDisabled = (testId: string) => hands.find<HTMLButtonElement>(testId).disabled;

it("a run of another window is offered and watched, said to be of another mission, and left", async () => {
  await open(<Watching />);
  expect(hands.has("watching-bar")).toBe(false);
  await settle(() => useDisk.setState({ runs: ["theirs"] }));
  expect(bar().dataset["watching"]).toBe("false");
  hands.click("watch-run");
  expect(watch).toHaveBeenCalledWith({ mission: MISSION, run: "theirs" });
  await settle(() => useRun.setState({ status: "running", watching: true, name: "theirs", another: true }));
  expect(bar().dataset["watching"]).toBe("true");
  expect(bar().textContent).toContain("is not what is open here");
  page.act(() => useRun.setState({ another: false }));
  expect(bar().textContent).not.toContain("is not what is open here");
  hands.click("watch-leave");
  expect(reset).toHaveBeenCalledOnce();
});

it("who runs something is offered no other run", async () => {
  useDisk.setState({ runs: ["theirs"] });
  useRun.setState({ status: "running", name: "mine" });
  await open(<Watching />);
  expect(hands.has("watching-bar")).toBe(false);
});

it("who watches can press nothing but to leave", async () => {
  useRun.setState({ status: "running", watching: true, abilities: [] });
  await open(
    <>
      <RunTools />
      <EventStrip />
    </>,
  );
  const steers = ["run-button", "pause-button", "step-button", "step-back-button", "step-vertex-button", "speed"];
  for (const testId of steers) expect(isDisabled(testId), testId).toBe(true);
  page.act(() => useRun.setState({ status: "paused" }));
  for (const testId of steers) expect(isDisabled(testId), testId).toBe(true);
  expect(hands.find("event-strip").getAttribute("aria-disabled")).toBe("true");
  expect(isDisabled("stop-button")).toBe(false);
});

it("the timeline is a slider for keys: its ends, a second, a tick", async () => {
  useRun.setState({ status: "paused", abilities: ["seek"], tick: 100, latest: 300, tickMs: 20 });
  await open(<EventStrip />);
  const strip = hands.find("event-strip");
  expect([strip.getAttribute("aria-valuenow"), strip.getAttribute("aria-valuemax")]).toEqual(["100", "300"]);
  for (const key of ["Home", "PageUp", "ArrowLeft", "End"]) hands.press("event-strip", key);
  expect(seek.mock.calls).toEqual([[0], [150], [99], [300]]);
  page.act(() => useRun.setState({ abilities: [] }));
  hands.press("event-strip", "Home");
  expect(seek).toHaveBeenCalledTimes(4);
});

const RECORDING: OpenRecording = {
  recording: "r",
  seed: 4,
  failRate: 0,
  cut: false,
  real: false,
  mission: MISSION,
  path: "recording:a/bug.krt",
};

it("a recording says what it is of, is played again once it has ended, and leads to a live run and back", async () => {
  useRun.setState({ status: "running", recording: true });
  await open(<RecordingBar open={RECORDING} />);
  const recording = () => hands.find("recording-bar");
  expect(recording().textContent).toContain("bug.krt, seed 4");
  expect(hands.has("play-recording")).toBe(false);
  page.act(() => useRun.setState({ status: "end" }));
  expect(hands.has("play-recording")).toBe(true);
  page.act(() => useRun.setState({ recording: false }));
  expect([recording().dataset["playing"], hands.has("run-recorded")]).toEqual(["false", false]);
  expect(recording().textContent).toContain("runs anew");
});

it("a recording that is cut off says so, and one that pauses at a part", async () => {
  useRun.setState({ status: "running", recording: true });
  await open(<RecordingBar open={{ ...RECORDING, cut: true, real: true }} />);
  const says = () => hands.find("recording-bar").textContent;
  expect(says()).toContain("cut off");
  expect(says()).toContain("a recording of a real robot");
  expect(says()).not.toContain("Pause here");
  const breakpoint = { program: "carrier", vertex: "v1" };
  page.act(() =>
    useStudio.getState().execute({
      label: "Pause",
      execute: (mission) => ({ ...mission, breakpoints: [breakpoint] }),
    }),
  );
  expect(says()).toContain("Pause here");
});

it("what is shown of real robots is their past, and leads to now; who watches does not lead it", async () => {
  await open(<BehindBar />);
  expect(hands.find("behind-bar").textContent).toContain("does not pause them");
  hands.click("follow");
  expect(follow).toHaveBeenCalledOnce();
  page.act(() => useRun.setState({ watching: true }));
  expect(hands.has("follow")).toBe(false);
});

it("the moment on the timeline has its tick, but not in the simple view", async () => {
  useRun.setState({ status: "paused", abilities: ["seek"], tick: 100, seconds: 2, latest: 300, tickMs: 20 });
  await open(<EventStrip />);
  const says = () => hands.find("event-strip").getAttribute("aria-valuetext");
  expect(says()).toContain("tick 100");
  page.act(() => chooseSimple(true));
  expect(says()).toMatch(/^[\d:.]+$/u);
  page.act(() => chooseSimple(false));
});
