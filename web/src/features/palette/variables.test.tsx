/** Variables are made, renamed, changed and removed in the palette; what cannot be is said at its field. */
import { afterEach, beforeEach, describe, expect, it } from "vitest";

import type { VariableAsk } from "../../api/generated";
import { Banner } from "../../app/Banner";
import { ownVariables } from "../../model/own-parts";
import { CARRIER, missionOf } from "../../model/testing/missions";
import { PARTS } from "../../model/testing/parts";
import { useStudio } from "../../model/studio";
import type { RobotObject } from "../../model/types";
import { dismissBanner } from "../../session/document";
import { useVariables } from "../../session/variables";
import { type Graph, leaveGraph, mountGraph } from "../../testing/graph";
import { refusal, testLine, type TestLine } from "../../testing/socket";
import { Palette } from "./Palette";

const COUNT = PARTS.robots[0]?.objects.find((one) => one.name === "Count") as RobotObject;
/** As the server makes it of what is wanted. */
const made = ({ robot, name, min, max, initial, shared, type }: VariableAsk) => ({
  robot,
  variable: { ...COUNT, name, min, max, initial, shared, type },
});

let page: Graph;
let line: TestLine;
const own = () => ownVariables(useStudio.getState().mission).map(({ variable }) => variable);
const elements = () => useStudio.getState().mission.programs[0]?.vertices.map((one) => one.element) ?? [];
const isFocused = (testId: string) => expect(document.activeElement).toBe(page.find(testId));
const why = () => page.find("variable-why").textContent;

beforeEach(async () => {
  line = testLine({ "api/variable": made });
  page = await mountGraph(
    missionOf(CARRIER),
    <>
      <Banner />
      <Palette />
    </>,
  );
});
afterEach(() => {
  leaveGraph(page);
  line.end();
  dismissBanner();
  useVariables.setState(useVariables.getInitialState());
});

async function open(): Promise<void> {
  page.click("new-variable");
  await page.until(() => isFocused("variable-name"));
}

function make(name: string, fields: Record<string, string> = {}): void {
  page.fill("variable-name", name);
  for (const [field, value] of Object.entries(fields)) page.fill(`variable-${field}`, value);
  page.click("variable-keep");
}

async function trips(): Promise<void> {
  await open();
  make("Trips", { max: "9", initial: "2" });
  await page.until(() => expect(page.has("object-Trips")).toBe(true));
}

async function press(testId: string, key: string): Promise<void> {
  page.act(() => page.find(testId).focus());
  await page.key(key);
}

describe("a variable", () => {
  it("is made by a form, which goes; its parts are added by a click; undo takes it away", async () => {
    await trips();
    expect([page.has("variable-form"), own()]).toMatchObject([false, [{ name: "Trips", min: 0, max: 9, initial: 2 }]]);
    page.click("part-Trips.Set");
    expect(elements()).toContain("Trips.Set");
    page.undo();
    page.undo();
    expect([own(), page.has("object-Trips")]).toEqual([[], false]);
  });

  it("is renamed in its row wherever it is used, and its row has the focus", async () => {
    await trips();
    page.click("part-Trips.Set");
    await press("object-Trips", "F2");
    await page.until(() => isFocused("variable-rename"));
    page.fill("variable-rename", "Runden");
    page.press("variable-rename", "Enter");
    await page.until(() => isFocused("object-Runden"));
    expect(elements()).toContain("Runden.Set");
    expect(elements()).not.toContain("Trips.Set");
  });

  it("is changed from its menu, where a finger that rests opens it too", async () => {
    await trips();
    await page.rightClick("object-Trips");
    page.click("menu-variable-edit");
    await page.until(() => expect(page.find<HTMLInputElement>("variable-max").value).toBe("9"));
    page.fill("variable-max", "500");
    page.click("variable-shared");
    page.click("variable-keep");
    await page.until(() => expect(page.has("variable-form")).toBe(false));
    expect(own()).toMatchObject([{ name: "Trips", max: 500, initial: 2, shared: true }]);
    const finger = { pointerType: "touch", bubbles: true, isPrimary: true };
    page.act(() => page.find("object-Count").dispatchEvent(new PointerEvent("pointerdown", finger)));
    await page.until(() => expect(page.has("variable-menu")).toBe(true));
    await page.key("Escape");
    expect(page.has("variable-menu")).toBe(false);
  });

  it("that is not used goes at once, and the way to a new one has the focus", async () => {
    await trips();
    await press("object-Trips", "Delete");
    expect(own()).toEqual([]);
    await page.until(() => isFocused("new-variable"));
  });

  it("that is used goes only after a question, which leads to where it is used", async () => {
    await trips();
    page.click("part-Trips.Set");
    page.act(() => useStudio.getState().select([]));
    await press("object-Trips", "Delete");
    const answer = (words: string) =>
      [...page.find("banner").querySelectorAll("button")].find((one) => one.textContent?.includes(words));
    expect(page.find("banner").textContent).toContain("Trips is used: 1 time in carrier");
    page.act(() => answer("Show in")?.click());
    expect([useStudio.getState().selection.length, page.has("banner")]).toEqual([1, true]);
    page.act(() => answer("Remove")?.click());
    expect([own(), page.has("banner")]).toEqual([[], false]);
    page.undo();
    expect(own()).toHaveLength(1);
  });
});

describe("what cannot be", () => {
  it("is said at the field in the server's words, and nothing is made", async () => {
    await open();
    line.answers["api/variable"] = refusal("`Captor` is a sensor of the robot.", "Take another name.");
    make("Captor");
    await page.until(() => expect(why()).toContain("Captor is a sensor of the robot. Take another name."));
    make("Trips", { min: "x" });
    expect(why()).toContain("whole numbers");
    await page.key("Escape");
    expect([page.has("variable-form"), own()]).toEqual([false, []]);
  });

  it("is a new name for one of the robot's own file, and it is said which file that is", async () => {
    line.answers["api/variable"] = refusal("`Count` stands in `carrier.robot.xml`.", "Change it there.");
    page.act(() => page.find("object-Count").dispatchEvent(new MouseEvent("dblclick", { bubbles: true })));
    await page.until(() => expect(page.find("banner").textContent).toContain("carrier.robot.xml"));
    expect(page.has("variable-rename")).toBe(false);
  });
});

describe("the palette", () => {
  it("has its tabs unless somebody searches; Enter adds the best, Escape shows all again", () => {
    const tabs = () => page.place.querySelectorAll(".palette-tab").length;
    expect(tabs()).toBeGreaterThan(4);
    page.fill("part-find", "light off");
    expect([tabs(), page.has("part-Lamp.LightOff"), page.has("part-While")]).toEqual([0, true, false]);
    const before = elements().filter((one) => one === "Lamp.LightOff").length;
    page.press("part-find", "Enter");
    expect(elements().filter((one) => one === "Lamp.LightOff")).toHaveLength(before + 1);
    page.press("part-find", "Escape");
    expect(tabs()).toBeGreaterThan(4);
  });

  it("says that no part is called so", () => {
    page.fill("part-find", "xyzzy");
    expect(page.find("parts-none").textContent).toContain("No part is called");
  });

  it("is walked by arrows, and Enter adds the part that has the focus", async () => {
    page.click("vertex-v20");
    page.fill("part-find", "wait");
    page.act(() => page.find("part-find").focus());
    await page.key("ArrowDown");
    isFocused("part-Wait");
    await page.key("Enter");
    expect(elements()).toContain("Wait");
  });
});
