/** The world is changed by keys, fields and drags; what is wrong stands at its thing; a template takes the place of it. */
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { moreWords } from "../../i18n/words";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { useStudio } from "../../model/studio";
import type { OwnWorld, Problem } from "../../model/types";
import { chosenIn, useWorld } from "../../session/world-view";
import { furnish, graphHands } from "../../testing/graph";
import { mount, type Mounted } from "../../testing/hooks";
import { testLine, type TestLine } from "../../testing/socket";
import World from "./World";

const ROOM: OwnWorld = {
  ...{ name: "room", width_mm: 4000, height_mm: 2000, walls: [], floors: [], lines: [], roads: [], storehouses: [] },
  ...{ docks: [], starts: [], boxes: [], balls: [], zones: [], unknown: [], label: {}, help: {} },
};
const MAZE: OwnWorld = { ...ROOM, name: "maze", walls: [{ x1: 0, y1: 0, x2: 9, y2: 9 }] };

let page: Mounted & ReturnType<typeof graphHands>;
let line: TestLine;
const world = () => useStudio.getState().mission.own_world as OwnWorld;
const number = (name: string) => Number(page.find<HTMLInputElement>(`world-${name}`).value);
const isSelected = (thing: string) => page.find(`thing-${thing}`).getAttribute("aria-selected") === "true";

beforeEach(async () => {
  furnish();
  await moreWords();
  vi.spyOn(HTMLCanvasElement.prototype, "getContext").mockReturnValue(null);
  line = testLine({ "api/world/templates": [{ name: "maze", world: MAZE }] });
  useStudio.getState().openMission(fileOf({ ...missionOf(CARRIER), own_world: ROOM }));
  const shown = mount(<World />);
  page = { ...shown, ...graphHands(shown) };
});
afterEach(() => {
  page.end();
  line.end();
  useWorld.setState(useWorld.getInitialState());
  vi.restoreAllMocks();
});

function type(name: string, value: string): void {
  page.fill(`world-${name}`, value);
  page.press(`world-${name}`, "Enter");
}

async function keys(...pressed: string[]): Promise<void> {
  page.act(() => page.find("world-stage").focus());
  for (const key of pressed) {
    const name = key.split("+").at(-1) ?? "";
    await page.key(name, { shiftKey: key.includes("Shift+"), ctrlKey: key.includes("Ctrl+") });
  }
}

describe("by the keyboard", () => {
  it("a tool puts its thing into the middle, arrows move it on the stage by 1 and 10 mm", async () => {
    page.click("world-tool-wall");
    expect(isSelected("wall-0")).toBe(true);
    expect(["x1", "y1", "x2", "y2"].map(number)).toEqual([1850, 1000, 2150, 1000]);
    await keys("ArrowUp", "Shift+ArrowUp", "ArrowRight");
    expect([number("x1"), number("y1")]).toEqual([1851, 1011]);
    await keys("Ctrl+d");
    expect([world().walls.length, isSelected("wall-1")]).toEqual([2, true]);
    await keys("Delete");
    expect(world().walls).toHaveLength(1);
    page.undo();
    expect(world().walls).toHaveLength(2);
  });

  it("the list of things is walked, N goes on among them, Enter leads to the stage, Escape lets go", async () => {
    page.click("world-tool-wall");
    page.click("world-tool-wall");
    page.act(() => page.find("thing-wall-1").focus());
    await page.key("ArrowUp");
    await page.until(() => expect(document.activeElement).toBe(page.find("thing-wall-0")));
    expect(isSelected("wall-0")).toBe(true);
    await page.key("Enter");
    expect(document.activeElement).toBe(page.find("world-stage"));
    await keys("n");
    expect(isSelected("wall-1")).toBe(true);
    await keys("Escape");
    expect([chosenIn(world(), useWorld.getState().chosen), page.has("world-width_mm")]).toEqual([[], true]);
  });
});

describe("by its numbers", () => {
  it("a zone is how loud and how far it is felt, a circle or a rectangle; a box has its mass", () => {
    page.click("world-tool-zone");
    type("value", "80");
    page.choose("world-zone-kind", "loud");
    type("radius_mm", "300");
    page.choose("world-shape", "rectangle");
    expect(["width_mm", "height_mm"].map(number)).toEqual([600, 600]);
    page.click("world-tool-box");
    type("mass", "900");
    expect([world().zones?.length, world().boxes?.[0]]).toMatchObject([1, { mass_g: 900 }]);
    while (useStudio.getState().canUndo) page.undo();
    expect(world()).toEqual(ROOM);
  });

  it("the world itself is as large as is wanted", () => {
    type("width_mm", "1500");
    expect(world().width_mm).toBe(1500);
  });
});

it("what is wrong is told at its thing, in the list and among its numbers", () => {
  page.click("world-tool-road");
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
  const message = "There is no room for this radius";
  const wrong = { ...where, severity: "error", code: "world", message, help: "", thing: "road:0" };
  page.act(() => useStudio.getState().setReport({ programs: [], problems: [wrong as Problem] }));
  const row = page.find("thing-road-0");
  expect([row.getAttribute("aria-label"), row.querySelector(".tab-error")]).toEqual([
    expect.stringContaining(message),
    expect.anything(),
  ]);
  expect(page.find("world-chosen").textContent).toContain(message);
});

it("a template takes the place of all of it, a maze for every number, and undo brings it back", async () => {
  page.click("world-tool-zone");
  const before = world();
  page.click("world-templates-open");
  await page.until(() => expect(page.has("template-maze")).toBe(true));
  type("maze-seed", "5");
  await page.until(() => expect(line.asked.at(-1)?.[0]).toContain("seed=5"));
  page.click("template-maze");
  expect([world().walls.length, world().zones?.length]).toEqual([1, 0]);
  page.undo();
  expect(world()).toEqual(before);
});
