/** Roles, groups and work of a team are made by keys, menus and drags; what cannot be is said. */
import { act } from "react";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { moreWords } from "../../../i18n/words";
import { playing } from "../../../model/commands/castAgents";
import { emptyProgram } from "../../../model/commands/changePrograms";
import { fileOf } from "../../../model/testing/missions";
import { useStudio } from "../../../model/studio";
import type { Agent, Mission, Problem } from "../../../model/types";
import { furnish } from "../../../testing/graph";
import { type Hands, handsOn } from "../../../testing/hands";
import { mount, type Mounted } from "../../../testing/hooks";
import Roster from "./Roster";

const agent = (name: string): Agent => ({ name, program: "convoy", start: "", robot: "carrier" });
const MISSION: Mission = {
  ...{ version: 1, programs: [emptyProgram("convoy", "", "social")], goals: [], world: "" },
  agents: ["r1", "r2", "r3", "r4"].map(agent),
  roles: [
    { name: "leader", robot: "carrier", least: 1, most: 1 },
    { name: "follower", robot: "carrier", least: 2, most: 2 },
  ],
  groups: [{ name: "all", members: ["leader", "follower"], failure: "substitute" }],
};

let page: Mounted;
let hands: Hands;
const mission = () => useStudio.getState().mission;
const roleOf = (name: string) => playing(mission()).get(name) ?? "";
const members = () => mission().groups?.[0]?.members;
const text = (testId: string) => hands.find(testId).textContent;
/** Two pictures: the card of what is new is drawn, then its field. */
const frames = () =>
  act(
    () =>
      new Promise<void>((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(() => done())))),
  );
const undo = () => page.act(() => useStudio.getState().undo());

beforeEach(async () => {
  furnish();
  await moreWords();
  useStudio.getState().openMission(fileOf(MISSION));
  page = mount(<Roster />);
  hands = handsOn({ ...page, place: document.body });
});
afterEach(() => {
  page.end();
  vi.restoreAllMocks();
});

/** Drags a chip over a card, and lets go there unless it is only held. */
function drag(chip: string, card: string, isHeld = false): void {
  document.elementFromPoint = () => hands.find(card);
  const send = (kind: string, on: EventTarget, x: number) =>
    page.act(() =>
      on.dispatchEvent(
        new PointerEvent(kind, { bubbles: true, isPrimary: true, pointerId: 1, clientX: x, clientY: 9 }),
      ),
    );
  send("pointerdown", hands.find(chip), 9);
  send("pointermove", window, 60);
  if (!isHeld) send("pointerup", window, 60);
}

describe("robots", () => {
  it("are dragged into roles and out, which count them, and undo brings them back", () => {
    expect([text("card-leader"), roleOf("r4")]).toEqual([expect.stringContaining("1 of 1"), ""]);
    drag("chip-r4", "card-leader");
    expect([roleOf("r4"), mission().roles?.[0]]).toEqual([
      "leader",
      { name: "leader", robot: "carrier", least: 1, most: 2 },
    ]);
    drag("chip-r4", "card-follower");
    expect([roleOf("r4"), text("card-follower")]).toEqual(["follower", expect.stringContaining("3 of")]);
    drag("chip-r4", "card-spare");
    expect(roleOf("r4")).toBe("");
    for (let step = 0; step < 3; step++) undo();
    expect(mission()).toEqual(MISSION);
  });

  it("the last one of a role stays, and it is said why, while it is dragged too", () => {
    drag("chip-r1", "card-spare", true);
    expect([hands.find("card-spare").dataset["over"], text("card-spare")]).toEqual([
      "refuses",
      expect.stringContaining("r1 is the last one in leader"),
    ]);
    page.act(() => window.dispatchEvent(new PointerEvent("pointerup", { pointerId: 1, clientX: 60, clientY: 9 })));
    expect([text("roster-said"), roleOf("r1")]).toEqual([
      expect.stringContaining("r1 is the last one in leader"),
      "leader",
    ]);
  });

  it("are dragged into groups, and Delete takes them out", () => {
    drag("chip-r2", "card-all");
    expect(members()).toEqual(["leader", "follower", "r2"]);
    hands.press("chip-all-r2", "Delete");
    expect(members()).toEqual(["leader", "follower"]);
  });

  it("are moved from the menu of their chip, where their role is marked", async () => {
    hands.click("chip-r4");
    expect(hands.find("menu-put-spare").getAttribute("aria-checked")).toBe("true");
    hands.click("menu-put-role-leader");
    await frames();
    expect(roleOf("r4")).toBe("leader");
  });
});

describe("what a team declares", () => {
  it("is added with the focus in its name, and named; work has units, a group its rule", async () => {
    hands.click("add-role");
    await frames();
    expect(document.activeElement).toBe(hands.find("name-role"));
    hands.fill("name-role", "scout");
    hands.press("name-role", "Enter");
    hands.click("add-work");
    await frames();
    hands.fill("name-Boxes", "Stones");
    hands.press("name-Boxes", "Enter");
    hands.fill("units-Stones", "7");
    hands.press("units-Stones", "Enter");
    hands.click("failure-all-abort");
    expect(mission().roles?.map(({ name }) => name)).toEqual(["leader", "follower", "scout"]);
    expect([mission().works, mission().groups?.[0]?.failure]).toEqual([[{ name: "Stones", units: 7 }], "abort"]);
  });

  it("is renamed wherever it is spoken of, and a name that is taken is refused in a sentence", () => {
    hands.click("change-leader");
    hands.fill("name-leader", "follower");
    expect(page.place.querySelector('[role="alert"]')?.textContent).toContain("follower is declared already.");
    hands.fill("name-leader", "head of all");
    hands.press("name-leader", "Enter");
    expect([mission().roles?.[0]?.name, members()]).toEqual(["head of all", ["head of all", "follower"]]);
  });

  it("is removed, and groups without it too", () => {
    hands.click("change-leader");
    hands.click("remove-leader");
    expect([mission().roles?.map(({ name }) => name), members()]).toEqual([["follower"], ["follower"]]);
  });

  it("has what the check says of it on its card", () => {
    const where = {
      file: "",
      line: 1,
      column: 1,
      end_line: 1,
      end_column: 2,
      program: "",
      vertices: [],
      arcs: [],
      fix: null,
    };
    const message = "the role `follower` wants 9 of the robot `carrier`";
    const wrong: Problem = { ...where, severity: "error", code: "team-roles", message, help: "" };
    page.act(() => useStudio.getState().setReport({ programs: [], problems: [wrong] }));
    expect([text("trouble-follower"), hands.has("trouble-leader")]).toEqual([
      expect.stringContaining("wants 9"),
      false,
    ]);
  });
});
