/** What people do to robots in the arena: hold their buttons, move their sliders, let them fail and come back. */
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { FAILED, MUTED, STALLED } from "../../api/wire";
import { isHeld, useHands } from "../../components/scene/hands";
import { moreWords } from "../../i18n/words";
import { clearFrames, pushFrame } from "../../session/poses";
import { useRun } from "../../session/run";
import type { RunAgent } from "../../session/run-state";
import { furnish } from "../../testing/graph";
import { type Hands as HandsOf, handsOn } from "../../testing/hands";
import { mount, type Mounted } from "../../testing/hooks";
import { Hands } from "./Hands";
import { RobotMenu } from "./RobotMenu";
import { openRobotMenu, useRobots } from "./robots";

const KEYS = [{ sensor: "ButtonB", label: "Button B", letter: "b", pressed: false, onBoard: true }];
const SLIDERS = [{ sensor: "Moisture", label: "Moisture", value: 70, min: 0, max: 100 }];

let page: Mounted;
let hands: HandsOf;
const [force, injectFault, closed] = [vi.fn(), vi.fn(), vi.fn()];

beforeEach(async () => {
  furnish();
  await moreWords();
  useRun.setState({ force, injectFault, agents: [{ name: "b" } as RunAgent] });
  page = mount(
    <>
      <Hands agent="b" keys={KEYS} sliders={SLIDERS} />
      <RobotMenu onClosed={closed} />
    </>,
  );
  hands = handsOn({ ...page, place: document.body });
});
afterEach(() => {
  page.end();
  for (const one of [force, injectFault, closed]) one.mockClear();
  clearFrames();
  useRun.setState(useRun.getInitialState());
  useHands.setState({ held: [] });
  useRobots.setState(useRobots.getInitialState());
});

const begin = () => page.act(() => useRun.setState({ status: "running", name: "r", abilities: ["force", "fail"] }));
const button = () => hands.find<HTMLButtonElement>("hand-ButtonB");

describe("before a run", () => {
  it("nothing can be held, and it is said what is missing; the menu says so too", () => {
    expect([button().disabled, hands.find<HTMLInputElement>("hand-Moisture").disabled]).toEqual([true, true]);
    expect(hands.find("hands").textContent).toContain("Press Run first");
    page.act(() => openRobotMenu("b", 0, 0));
    expect(hands.find("robot-menu").textContent).toContain("Press Run first");
    expect(hands.find("menu-harm-fail").getAttribute("aria-disabled")).toBe("true");
  });
});

describe("in a run", () => {
  beforeEach(begin);
  const send = (event: Event) => page.act(() => button().dispatchEvent(event));

  it("a button is held by a pointer until it is let go", () => {
    send(new PointerEvent("pointerdown", { bubbles: true, pointerId: 1 }));
    expect([button().getAttribute("aria-pressed"), force.mock.lastCall]).toEqual(["true", ["b", "ButtonB", 1]]);
    const felt = { name: "b", inputs: { ButtonB: 1 } } as unknown as RunAgent;
    page.act(() => useRun.setState({ agents: [felt] }));
    send(new PointerEvent("pointerup", { bubbles: true, pointerId: 1 }));
    expect([isHeld(useHands.getState().held, "b", "ButtonB"), force.mock.lastCall]).toEqual([
      false,
      ["b", "ButtonB", null],
    ]);
  });

  it.each([" ", "Enter"])("a button is held by the key %j", (key) => {
    send(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
    send(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true, repeat: true }));
    expect([button().getAttribute("aria-pressed"), force.mock.calls]).toEqual(["true", [["b", "ButtonB", 1]]]);
  });

  it("a slider sets its sensor, and shows that at once", () => {
    hands.fill("hand-Moisture", "5");
    expect([force.mock.lastCall, hands.find("hands").querySelector("output")?.textContent]).toEqual([
      ["b", "Moisture", 5],
      "5",
    ]);
  });

  it("the menu of a robot lets it fail and come back, and gives the focus back", () => {
    page.act(() => openRobotMenu("b", 0, 0));
    hands.click("menu-harm-fail");
    expect([injectFault.mock.lastCall, closed.mock.calls.length, hands.has("robot-menu")]).toEqual([
      ["b", "fail"],
      1,
      false,
    ]);
  });

  it.each([
    [FAILED, { fail: true, stall: true, mute: false, revive: false }],
    [STALLED, { fail: false, stall: true, mute: false, revive: false }],
    [MUTED, { fail: false, stall: false, mute: true, revive: false }],
    [0, { fail: false, stall: false, mute: false, revive: true }],
  ])("what a robot is already cannot be chosen (flags %i)", (flags, off) => {
    pushFrame({ tick: 1, poses: [{ x_mm: 0, y_mm: 0, heading_rad: 0, load: 0, flags }] }, 0);
    page.act(() => openRobotMenu("b", 0, 0));
    const isOff = (kind: string) => hands.find(`menu-harm-${kind}`).getAttribute("aria-disabled") === "true";
    expect(Object.fromEntries(Object.keys(off).map((kind) => [kind, isOff(kind)]))).toEqual(off);
  });

  it("who is followed is marked, and let go by the same entry", () => {
    page.act(() => openRobotMenu("b", 0, 0));
    hands.click("menu-harm-follow");
    expect(useRobots.getState().followed).toBe("b");
    page.act(() => openRobotMenu("b", 1, 1));
    expect(hands.find("menu-harm-follow").getAttribute("aria-checked")).toBe("true");
    hands.click("menu-harm-follow");
    expect(useRobots.getState().followed).toBe("");
  });
});
