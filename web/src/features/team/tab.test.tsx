/** What is done in the tab of the team becomes commands, each undone by itself. */
import { act } from "react";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { moreWords, speak } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import held from "../../model/testing/worlds.json";
import type { Mission, World } from "../../model/types";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted } from "../../testing/hooks";
import { Agents } from "./Agents";
import { Conditions } from "./Conditions";
import { Failures } from "./Failures";
import { Goals } from "./Goals";
import { About } from "./Team";

const MISSION: Mission = {
  ...missionOf(CARRIER, { ...CARRIER, name: "loader" }),
  agents: ["a", "b", "c"].map((name) => ({ name, program: "carrier", start: "" })),
};

const RING = held.find(({ drawn }) => drawn.name === "ring")?.drawn as unknown as World;
const PATIENCE_MS = 60_000;

let page: Mounted;
let hands: Hands;
const mission = () => useStudio.getState().mission;
const names = () => mission().agents.map(({ name }) => name);
const value = (testId: string) => hands.find<HTMLInputElement>(testId).value;
const isWrong = (testId: string) => hands.find(testId).getAttribute("aria-invalid") === "true";
/** Waits for what comes with a later frame, or with what is fetched later. */
const waitFor = (fact: () => void) =>
  vi.waitFor(async () => {
    await act(() => Promise.resolve());
    fact();
  }, PATIENCE_MS);
/** Presses a button whose work is fetched when it is wanted. */
const clickAndFetch = (testId: string) =>
  act(async () => {
    hands.find(testId).click();
    await import("../../session/world-edits");
  });
const isFocused = (testId: string) => expect(document.activeElement).toBe(hands.find(testId));

beforeEach(async () => {
  await speak("en");
  await moreWords();
  useStudio.getState().openMission(fileOf(MISSION));
  page = mount(
    <>
      <Agents />
      <Goals />
      <Failures />
      <Conditions />
      <About />
    </>,
  );
  hands = handsOn(page);
});
afterEach(async () => {
  page.end();
  await speak("en");
});

function undoAll(): void {
  page.act(() => {
    while (useStudio.getState().canUndo) useStudio.getState().undo();
  });
  expect(mission()).toEqual(MISSION);
}

describe("robots", () => {
  it("are named, and a name that another has is refused in a sentence", () => {
    hands.fill("agent-name-2", "a");
    expect(isWrong("agent-name-2")).toBe(true);
    expect(page.place.querySelector('[role="alert"]')?.textContent).toContain("There is a robot a already.");
    hands.press("agent-name-2", "Enter");
    expect(names()).toEqual(["a", "b", "c"]);
    hands.fill("agent-name-2", "scout");
    hands.press("agent-name-2", "Enter");
    expect(names()).toEqual(["a", "b", "scout"]);
    // Its start had its old name: it stays there.
    expect(mission().agents[2]?.start).toBe("c");
    undoAll();
  });

  it("get a program and go up and down, where the focus goes with them", async () => {
    hands.choose("agent-program-2", "loader");
    expect(mission().agents[2]?.program).toBe("loader");
    hands.click("agent-up-2");
    expect(names()).toEqual(["a", "c", "b"]);
    await waitFor(() => isFocused("agent-up-1"));
    hands.press("agent-name-1", "ArrowUp", { altKey: true });
    expect(names()).toEqual(["c", "a", "b"]);
    await waitFor(() => isFocused("agent-name-0"));
    hands.click("agent-up-0");
    expect(names()).toEqual(["c", "a", "b"]);
    undoAll();
  });

  it("are added with the focus in their name, copied under a name of their own, and removed", async () => {
    await clickAndFetch("add-agent");
    await waitFor(() => isFocused("agent-name-3"));
    expect(new Set(names()).size).toBe(4);
    hands.fill("agent-name-3", "scout");
    hands.press("agent-name-3", "Enter");
    await clickAndFetch("agent-copy-3");
    expect(names().slice(3)).toEqual(["scout", "scout-1"]);
    hands.click("agent-remove-4");
    hands.click("agent-remove-3");
    expect(names()).toEqual(["a", "b", "c"]);
    await waitFor(() => isFocused("agent-remove-2"));
    undoAll();
  });
});

describe("goals", () => {
  it("are added with the focus in the first storehouse that has none, changed, and removed", async () => {
    const { worldOf } = useStudio.getState();
    page.act(() => useStudio.getState().loadWorld(worldOf, RING));
    hands.click("add-goal");
    await waitFor(() => isFocused("goal-house-0"));
    expect(mission().goals).toEqual([{ storehouse: "A", stock: "all" }]);
    hands.choose("goal-all-0", "");
    hands.fill("goal-stock-0", "7");
    hands.press("goal-stock-0", "Enter");
    hands.choose("goal-house-0", "B");
    expect(mission().goals).toEqual([{ storehouse: "B", stock: "7" }]);
    hands.click("add-goal");
    await waitFor(() => isFocused("goal-house-1"));
    expect(value("goal-house-1")).toBe("A");
    hands.click("goal-remove-1");
    await waitFor(() => isFocused("add-goal"));
    expect(mission().goals).toHaveLength(1);
    undoAll();
  });

  it("of a storehouse that the world has not are marked", () => {
    page.act(() => useStudio.getState().openMission(fileOf({ ...MISSION, goals: [{ storehouse: "X", stock: "3" }] })));
    page.act(() => useStudio.getState().loadWorld(useStudio.getState().worldOf, RING));
    expect(isWrong("goal-house-0")).toBe(true);
  });
});

describe("the schedule of failures", () => {
  it("has rows that are added, changed and taken away", () => {
    hands.click("add-failure");
    expect(value("failure-at-0")).toBe("10");
    hands.choose("failure-agent-0", "b");
    hands.choose("failure-kind-0", "stall");
    hands.fill("failure-at-0", "0.5");
    hands.press("failure-at-0", "Enter");
    expect(mission().failures).toEqual([{ agent: "b", at_s: 0.5, kind: "stall" }]);
    page.act(() => useStudio.getState().undo());
    expect(value("failure-at-0")).toBe("10");
    page.act(() => useStudio.getState().redo());
    hands.click("failure-remove-0");
    expect(hands.has("failure-0")).toBe(false);
    undoAll();
  });
});

describe("the conditions", () => {
  it("are a radio, whose wrong numbers are taken back, and what becomes of failed robots", () => {
    hands.click("radio-on");
    hands.fill("radio-range", "1500");
    hands.press("radio-range", "Enter");
    hands.fill("radio-loss", "a lot");
    expect(isWrong("radio-loss")).toBe(true);
    hands.press("radio-loss", "Enter");
    expect(value("radio-loss")).toBe("0");
    hands.fill("radio-delay", "20");
    hands.press("radio-delay", "Enter");
    expect(mission().radio).toEqual({ range_mm: 1500, delay_ms: 20, loss: 0 });
    expect(hands.has("breakdown-after")).toBe(false);
    hands.choose("breakdown-rule", "tow");
    hands.fill("breakdown-after", "2,5");
    hands.press("breakdown-after", "Enter");
    expect(mission().breakdown).toEqual({ rule: "tow", after_s: 2.5 });
    undoAll();
    expect(hands.find<HTMLInputElement>("radio-on").checked).toBe(false);
    expect(value("breakdown-rule")).toBe("stay");
  });
});

describe("title and help", () => {
  it("are written in the language of the page, and English stands in for them until then", async () => {
    hands.fill("team-title", "My square");
    await act(() => speak("ur"));
    page.end();
    page = mount(<About />);
    hands = handsOn(page);
    expect(hands.find<HTMLInputElement>("team-title")).toMatchObject({ value: "", placeholder: "My square" });
    hands.fill("team-title", "میرا مربع");
    hands.fill("team-help", "چلتا ہے");
    expect(mission().label).toEqual({ "": "My square", ur: "میرا مربع" });
    expect(mission().help).toEqual({ ur: "چلتا ہے" });
    undoAll();
  });
});
