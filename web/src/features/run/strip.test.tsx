/** The timeline leads anywhere in a run by keys, and shows what happened and what is still to come. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { moreWords } from "../../i18n/words";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { useStudio } from "../../model/studio";
import { useRun } from "../../session/run";
import { furnish } from "../../testing/graph";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted } from "../../testing/hooks";
import { EventStrip } from "./EventStrip";

let page: Mounted;
let hands: Hands;
const seek = vi.fn((tick: number) => useRun.setState({ tick }));

beforeEach(async () => {
  furnish();
  await moreWords();
  const failures = [{ agent: "carrier-1", at_s: 10, kind: "stall" as const }];
  useStudio.getState().openMission(fileOf({ ...missionOf(CARRIER), failures }));
  useRun.setState({ status: "paused", tick: 100, latest: 200, seconds: 2, tickMs: 20, abilities: ["seek"], seek });
  page = mount(<EventStrip />);
  hands = handsOn(page);
});
afterEach(() => {
  page.end();
  seek.mockClear();
  useRun.setState(useRun.getInitialState());
});

it("keys go a tick, a second, and to both ends, and no further", () => {
  const led = ["ArrowRight", "PageUp", "ArrowLeft", "Home", "ArrowLeft", "End", "ArrowRight"].map((key) => {
    hands.press("event-strip", key);
    return seek.mock.lastCall?.[0];
  });
  expect(led).toEqual([101, 151, 150, 0, 0, 200, 200]);
  expect(hands.find("event-strip").getAttribute("aria-valuenow")).toBe("200");
});

it("its handle is dragged, and stays within the run", () => {
  const strip = hands.find("event-strip");
  Element.prototype.hasPointerCapture = () => true;
  const send = (kind: string, x: number) =>
    page.act(() => strip.dispatchEvent(new PointerEvent(kind, { bubbles: true, clientX: x, pointerId: 1 })));
  send("pointerdown", -50);
  expect(seek.mock.lastCall?.[0]).toBe(0);
  send("pointermove", 5000);
  expect(seek.mock.lastCall?.[0]).toBe(200);
});

it("a failure on the schedule is shown until its moment has passed", () => {
  page.act(() => useRun.setState({ latest: 499 }));
  expect(hands.has("planned-stall")).toBe(true);
  page.act(() => useRun.setState({ latest: 501 }));
  expect(hands.has("planned-stall")).toBe(false);
  const happened = {
    tick: 500,
    kind: "failure" as const,
    agent: "carrier-1",
    text: "stalls",
    cause: "mission" as const,
  };
  page.act(() => useRun.setState({ events: [happened] }));
  expect(page.place.querySelectorAll('[data-kind="failure"]')).toHaveLength(1);
});

it("a run that cannot be gone back in has no handle, and keys lead nowhere", () => {
  page.act(() => useRun.setState({ abilities: [] }));
  hands.press("event-strip", "Home");
  expect([hands.has("strip-handle"), seek.mock.calls.length]).toEqual([false, 0]);
});
