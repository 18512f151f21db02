/** The mission's world is chosen among all that there are; robots without a start get one by a click. */
import { act } from "react";
import { afterEach, beforeEach, describe, expect, it } from "vitest";

import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import held from "../../model/testing/worlds.json";
import type { Mission, World } from "../../model/types";
import { useRun } from "../../session/run";
import { furnish } from "../../testing/graph";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted } from "../../testing/hooks";
import { type TestLine, testLine } from "../../testing/socket";
import { Agents } from "./Agents";
import { Chance } from "./Failures";
import { Worlds } from "./Worlds";

const RING = held.find(({ drawn }) => drawn.name === "ring")?.drawn as unknown as World;
const entry = (href: string, shipped: boolean) => ({ href, world: RING, label: {}, help: {}, shipped });
const MISSION: Mission = {
  ...missionOf(CARRIER),
  agents: ["a", "b"].map((name) => ({ name, program: "carrier", start: "" })),
};

let page: Mounted;
let hands: Hands;
let line: TestLine;
const mission = () => useStudio.getState().mission;

async function show(world: World | null): Promise<void> {
  useStudio.getState().openMission({ ...fileOf(MISSION), world });
  page = mount(
    <>
      <Agents />
      <Worlds />
      <Chance />
    </>,
  );
  hands = handsOn(page);
  await act(() => new Promise<void>((done) => setTimeout(done)));
}
beforeEach(async () => {
  furnish();
  await moreWords();
  line = testLine({ "api/worlds": [entry("ring.world.xml", true), entry("yard.world.xml", false)] });
});
afterEach(() => {
  page.end();
  line.end();
  useRun.setState(useRun.getInitialState());
});

describe("worlds", () => {
  it("of the folder stand beside those that come along, and the one that is chosen is the mission's, until undo", async () => {
    await show(null);
    expect(hands.find("world-yard").textContent).toContain("from this folder");
    expect(hands.find("world-ring").textContent).not.toContain("from this folder");
    page.act(() => hands.find("world-yard").querySelector("input")?.click());
    expect(mission().world).toBe("yard.world.xml");
    expect(hands.find("world-yard").querySelector("input")?.checked).toBe(true);
    page.act(() => useStudio.getState().undo());
    expect(mission().world).toBe("");
  });

  it("that is not there is told", async () => {
    await show(null);
    page.act(() => useStudio.setState({ mission: { ...mission(), world: "gone.world.xml" } }));
    expect(page.place.querySelector(".team-hint")?.textContent).toContain("gone.world.xml is not there");
  });
});

describe("robots without a start in this world", () => {
  it("are counted, and one click puts them on free ones; undo takes that back", async () => {
    await show(RING);
    expect(page.place.querySelector("[role=status]")?.textContent).toContain("2 robots have no start in this world");
    hands.click("place-agents");
    const known = RING.starts.map(({ name }) => name);
    expect(mission().agents.every(({ name, start }) => known.includes(start || name))).toBe(true);
    expect(new Set(mission().agents.map(({ start }) => start)).size).toBe(2);
    page.act(() => useStudio.getState().undo());
    expect(mission()).toEqual(MISSION);
  });
});

describe("failures by chance", () => {
  it("are as often as is wanted in the next run, no part of the mission, and stay while a run is on", async () => {
    await show(null);
    for (const wrong of ["101", "-1", "often"]) {
      hands.fill("fail-rate", wrong);
      expect(hands.find("fail-rate").getAttribute("aria-invalid")).toBe("true");
    }
    hands.fill("fail-rate", "100");
    hands.press("fail-rate", "Enter");
    expect([useRun.getState().failRate, useStudio.getState().dirty]).toEqual([1, false]);
    page.act(() => useRun.setState({ status: "running" }));
    expect(hands.find<HTMLInputElement>("fail-rate").disabled).toBe(true);
  });
});
