/** Find looks through all programs; folded parts say how much they hold; keys move the camera. */
import { afterEach, beforeEach, describe, expect, it } from "vitest";

import { CARRIER, missionOf } from "../../model/testing/missions";
import { useStudio } from "../../model/studio";
import { useRun } from "../../session/run";
import type { RunAgent } from "../../session/run-state";
import { useView } from "../../session/view";
import { type Graph, leaveGraph, middleOf, mountGraph } from "../../testing/graph";

let page: Graph;
const state = () => useStudio.getState();
beforeEach(async () => {
  page = await mountGraph(missionOf(CARRIER, { ...CARRIER, name: "other" }));
});
afterEach(() => {
  leaveGraph(page);
  useRun.setState(useRun.getInitialState());
});

/** The first robot of a program stands there, in a run. */
function stands(...active: [number, string][]): void {
  const agent = { name: "c-1", program: "carrier", active, inputs: { Sign: 0, Collision: 1 }, values: { Run: 1 } };
  page.act(() => useRun.setState({ status: "running", agents: [agent as unknown as RunAgent] }));
}

describe("find", () => {
  beforeEach(async () => {
    await page.key("f", { ctrlKey: true });
    await page.until(() => expect(document.activeElement).toBe(page.find("find-input")));
  });

  it("says that nothing says so", async () => {
    await page.type("no such words");
    expect(page.find("find").textContent).toContain("Nothing says");
  });

  it("goes through the hits of all programs with Enter and Shift+Enter, and keeps the focus", async () => {
    await page.type("lamp light off");
    expect(page.all("find-hit-*")).toHaveLength(2);
    await page.key("Enter");
    expect([state().activeProgram, state().selection]).toEqual(["carrier", ["v20"]]);
    await page.key("Enter");
    expect([state().activeProgram, state().selection]).toEqual(["other", ["v20"]]);
    await page.key("Enter", { shiftKey: true });
    expect(state().activeProgram).toBe("carrier");
    expect(document.activeElement).toBe(page.find("find-input"));
  });

  it("is closed by Escape, which gives the focus to the graph", async () => {
    await page.key("Escape");
    expect(page.has("find")).toBe(false);
    expect(document.activeElement).toBe(page.find("canvas"));
  });
});

describe("a folded part", () => {
  it("says how much it holds, glows for it, is no change, and C unfolds it", async () => {
    page.click("collapse-v1");
    await page.until(() => expect(document.querySelectorAll(".vertex")).toHaveLength(1));
    expect(page.find("expand-v1").textContent).toMatch(/\d+ parts/);
    stands([0, "v13"]);
    expect(page.find("vertex-v1").className).toContain("is-active");
    expect(state().dirty).toBe(false);
    page.click("vertex-v1");
    await page.key("c");
    expect(page.has("vertex-v13")).toBe(true);
  });
});

describe("a run on the graph", () => {
  it("chips say what sensors and variables say, filled while the test is true, and can be switched off", async () => {
    expect(page.all("live-*")).toEqual([]);
    stands([0, "v11"]);
    await page.until(() => expect(page.has("live-v4")).toBe(true));
    expect([page.find("live-v4").textContent, page.find("live-v4").dataset["on"]]).toEqual(["now 0", "true"]);
    expect(page.find("live-v14").dataset["on"]).not.toBe(page.find("live-v11").dataset["on"]);
    page.act(() => useView.setState({ live: false }));
    expect(page.all("live-*")).toEqual([]);
  });

  it("the second bar of a parallel says which branch has come and for which it waits", () => {
    stands([0, "v3"], [1, "v6"]);
    expect(page.find("waits-v3").textContent).toMatch(/^0\s*waits for\s*1$/);
  });
});

describe("the camera", () => {
  it("Z shows the selection as large as it is readable, M the map, and a wheel rests following", async () => {
    page.click("vertex-v13");
    await page.key("z");
    await page.until(() => expect(document.querySelector(".zoom-percent")?.textContent).toBe("125 %"));
    const { x, y } = middleOf("v13");
    expect([x > 0 && x < 904, y > 0 && y < 840]).toEqual([true, true]);
    await page.key("m");
    await page.until(() => expect(page.has("minimap")).toBe(true));
    await page.key("m");
    expect(page.has("minimap")).toBe(false);
  });
});
