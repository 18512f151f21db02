import { afterEach, beforeEach, describe, expect, it } from "vitest";

import { useStudio } from "../model/studio";
import { TEAM_ROBOT } from "../model/team-robot";
import { CARRIER, fileOf, missionOf } from "../model/testing/missions";
import type { Mission } from "../model/types";
import { useDocument } from "./document";
import { chooseSimple, type Detail, findNeed, isShown, readSimple, tellNeed } from "./simple-view";

const DETAILS: Detail[] = ["seed", "ticks", "places", "listing", "agents", "team", "threads", "verification"];

/** A browser that keeps that. */
function storageOf(kept: Record<string, string>): Pick<Storage, "getItem" | "key" | "length"> {
  const names = Object.keys(kept);
  return { getItem: (name) => kept[name] ?? null, key: (at) => names[at] ?? null, length: names.length };
}

function openMission(more: Partial<Mission> = {}): void {
  useStudio.getState().openMission(fileOf({ ...missionOf(CARRIER), ...more }));
  useDocument.setState({ ready: true, banner: null });
}

const robot = (name: string) => ({ name, program: "carrier", start: "" });
const shown = () => DETAILS.filter(isShown);

beforeEach(() => {
  openMission();
  chooseSimple(true);
});
afterEach(() => {
  chooseSimple(false);
  useDocument.setState({ banner: null });
});

describe("the view is simple", () => {
  it("for somebody who was never here, and not for one who has set something", () => {
    expect(readSimple(storageOf({}))).toBe(true);
    expect(readSimple(storageOf({ "kitrobot.token": "secret", "another-page": "1" }))).toBe(true);
    expect(readSimple(storageOf({ "kitrobot.theme": "dark" }))).toBe(false);
  });

  it("as it was left, whatever else is set", () => {
    expect(readSimple(storageOf({ "kitrobot.simple": "yes", "kitrobot.theme": "dark" }))).toBe(true);
    expect(readSimple(storageOf({ "kitrobot.simple": "no" }))).toBe(false);
    chooseSimple(false);
    expect(readSimple(localStorage)).toBe(false);
  });
});

describe("in the simple view", () => {
  it("no detail is shown, and by one switch each", () => {
    expect(shown()).toEqual([]);
    chooseSimple(false);
    expect(shown()).toEqual(DETAILS);
  });

  it("several robots show who runs what, and nothing more", () => {
    openMission({ agents: [robot("one")] });
    expect(shown()).toEqual([]);
    openMission({ agents: [robot("one"), robot("two")] });
    expect(shown()).toEqual(["agents"]);
  });

  it.each([
    ["team", { programs: [{ ...CARRIER, robot: TEAM_ROBOT }] }],
    ["team", { groups: [{ name: "scouts", members: [] }] }],
    ["properties", { properties: [{ name: "arrives" }] }],
    ["failures", { failures: [{ agent: "one", at_s: 3, kind: "kill" }] }],
    ["failures", { radio: { range_mm: 300 } }],
  ])("a mission with a need (%s) shows everything", (need, more) => {
    openMission(more as unknown as Partial<Mission>);
    expect([findNeed(useStudio.getState().mission), shown()]).toEqual([need, DETAILS]);
  });

  it("this is said once, of the first such mission, and not in the full view", () => {
    const end = tellNeed();
    const said = () => useDocument.getState().banner?.message;
    openMission();
    expect(said()).toBeUndefined();
    const failing = { radio: { range_mm: 300 } };
    chooseSimple(false);
    openMission(failing);
    expect(said()).toBeUndefined();
    chooseSimple(true);
    openMission(failing);
    expect(said()).toBe("In this mission robots can fail, so everything is shown.");
    openMission(failing);
    expect(said()).toBeUndefined();
    end();
  });
});
