/** The map of failures is asked for, comes over a socket, is walked by keys, and each of its fields is a run that plays. */
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import type { SweepMapMessage } from "../../api/generated";
import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { useRun } from "../../session/run";
import { furnish } from "../../testing/graph";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted } from "../../testing/hooks";
import { testLine, type TestLine } from "../../testing/socket";
import { SweepPanel } from "./SweepPanel";
import { useSweep } from "./sweep-session";

const MISSION = missionOf(CARRIER, { ...CARRIER, name: "loader" });
const ends = { outcome: "stuck", seconds: 12, sentence: "Nothing happens any more." } as const;
const MAP: SweepMapMessage = {
  ...{ type: "map", agents: ["carrier-1", "loader-1"], moments: [0, 2], outcome: "done", sentence: "All is done." },
  total: 4,
  fields: [0, 1].flatMap((agent) => [0, 1].map((moment) => ({ agent, moment, ...ends }))),
};

let page: Mounted;
let hands: Hands;
let line: TestLine;
const start = vi.fn<ReturnType<typeof useRun.getState>["start"]>();
const text = (testId: string) => hands.find(testId).textContent;
const at = () => (document.activeElement as HTMLElement).dataset["testid"];

beforeEach(async () => {
  furnish();
  await moreWords();
  line = testLine();
  useStudio.getState().openMission(fileOf(MISSION));
  useRun.setState({ start });
  page = mount(<SweepPanel />);
  hands = handsOn(page);
});
afterEach(() => {
  page.end();
  line.end();
  start.mockClear();
  useRun.setState(useRun.getInitialState());
  useSweep.setState(useSweep.getInitialState());
});

function begin(): void {
  hands.click("sweep-begin");
  page.act(() => line.sockets[0]?.open());
}

describe("asking", () => {
  it("says how many runs it takes, and takes no time that cannot be", () => {
    expect(text("sweep-begin")).toBe("Do 50 runs");
    hands.choose("sweep-moments", "10");
    expect(text("sweep-begin")).toBe("Do 20 runs");
    for (const wrong of ["0", "", "36001", "long"]) {
      hands.fill("sweep-seconds", wrong);
      expect(hands.find<HTMLButtonElement>("sweep-begin").disabled).toBe(true);
    }
    hands.fill("sweep-seconds", "40");
    begin();
    expect(line.sockets[0]?.sent).toMatchObject([{ type: "start", moments: 10, seconds: 40, path: "test.krt" }]);
  });

  it("says how far it is, and is broken off; what is refused or lost is told", () => {
    begin();
    page.act(() => line.sockets[0]?.say({ type: "progress", done: 2, total: 50 }));
    expect(text("sweep-progress")).toContain("2 of 50");
    hands.click("sweep-break-off");
    expect(line.sockets[0]?.sent.at(-1)).toEqual({ type: "stop" });
    page.act(() => line.sockets[0]?.say({ type: "refused", message: "There is a mistake.", help: "", problems: [] }));
    expect(text("refused")).toContain("There is a mistake.");
    hands.click("sweep-begin");
    page.act(() => line.sockets[1]?.lose());
    expect(useSweep.getState().refused?.message).not.toBe("");
  });
});

describe("the map", () => {
  beforeEach(() => {
    begin();
    page.act(() => line.sockets[0]?.say(MAP));
  });

  it("counts how runs end, and arrows, Home and End walk its fields", () => {
    expect(text("sweep-count-stuck")).toContain("4");
    page.act(() => hands.find("field-0-0").focus());
    const walked = ["ArrowRight", "ArrowDown", "ArrowUp", "ArrowLeft", "End", "Home"].map((key) => {
      hands.press(at() ?? "", key);
      return at();
    });
    expect(walked).toEqual(["0-1", "1-1", "0-1", "0-0", "0-1", "0-0"].map((one) => `field-${one}`));
  });

  it("plays the run of a field by Enter, and says how it ends; the mission stays as it is", () => {
    page.act(() => hands.find("field-0-0").focus());
    hands.press("field-0-0", "ArrowDown");
    hands.press("field-1-0", "ArrowRight");
    hands.press("field-1-1", "Enter");
    expect(hands.find("field-1-1").dataset["played"]).toBe("true");
    expect(start.mock.lastCall?.[1]?.mission?.failures).toEqual([{ agent: "loader-1", at_s: 2, kind: "fail" }]);
    expect(text("sweep-chosen")).toContain("Nothing happens any more.");
    expect(useStudio.getState().dirty).toBe(false);
  });

  it("is of the mission as it was asked about, and goes with it", () => {
    page.act(() => useStudio.setState({ mission: { ...MISSION } }));
    expect(page.place.querySelectorAll(".sweep-warning")).toHaveLength(1);
    page.act(() => useStudio.getState().openMission(fileOf(MISSION)));
    expect(hands.has("sweep-map")).toBe(false);
  });
});
