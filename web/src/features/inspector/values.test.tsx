/** A value is typed where it stands and in the inspector, in the units of people, and taken back by Escape. */
import { afterEach, beforeEach, describe, expect, it } from "vitest";

import { missionOf } from "../../model/testing/missions";
import { PARTS } from "../../model/testing/parts";
import { useStudio } from "../../model/studio";
import type { Catalogue, Meaning, Method, Program, RobotObject } from "../../model/types";
import { chooseSimple } from "../../session/simple-view";
import { setValues } from "../../session/varied-axes";
import { type Graph, leaveGraph, mountGraph } from "../../testing/graph";
import { Inspector } from "./Inspector";

const ANGLE = { field: "dial", scale: "3.6", units: { "": "°" } } as unknown as Meaning;
const FAR = { field: "ruler", scale: "1", units: { "": "cm" } } as unknown as Meaning;
const TIME = { field: "time", scale: "wait-unit", units: { "": "s" } } as unknown as Meaning;

/** The parts of tests with units: a turn in degrees, a distance in cm, a Wait in seconds. */
const MEASURED: Catalogue = {
  ...PARTS,
  groups: PARTS.groups.map((group) => ({
    ...group,
    constructors: group.constructors.map((one) =>
      one.name !== "Wait" ? one : { ...one, slots: one.slots.map((slot) => ({ ...slot, unit: "", meaning: TIME })) },
    ),
  })),
  robots: PARTS.robots.map((robot) => ({ ...robot, objects: robot.objects.map(measured) })),
};
function measured(object: RobotObject): RobotObject {
  const meaning = object.name === "Motor" ? ANGLE : object.name === "Sign" ? FAR : null;
  const wider = object.name === "Sign" ? { max: 100 } : {};
  const [first, ...rest] = ["angle", "value"];
  const parameters = ({ parameters }: Method) =>
    parameters.map((one) =>
      meaning !== null && [first, ...rest].includes(one.name) ? { ...one, ...wider, unit: "", meaning } : one,
    );
  return { ...object, ...wider, methods: object.methods.map((one) => ({ ...one, parameters: parameters(one) })) };
}

const part = (id: string, element: string, settings: Record<string, string> = {}) => ({
  id,
  element,
  settings,
  notes: [],
});
const arc = (source: string, out: string, target: string, at = "in") => ({ source, out, target, at });
const PROGRAM: Program = {
  name: "p",
  robot: "carrier",
  vertices: [
    part("start", "Start"),
    part("turn", "Motor.AbsoluteTurn", { angle: "25", speed: "50" }),
    part("wait", "Wait", { time: "10" }),
    part("when", "When"),
    part("near", "Sign.LessThan", { value: "20" }),
    part("halt", "Wheel.Stop"),
    part("stop", "Stop"),
  ],
  arcs: [
    arc("start", "next", "turn"),
    arc("turn", "next", "wait"),
    arc("wait", "next", "when"),
    arc("near", "next", "when", "condition"),
    arc("when", "body", "halt"),
    arc("halt", "next", "when", "return"),
    arc("when", "next", "stop"),
  ],
};

let page: Graph;
const setting = (id: string, name: string) =>
  useStudio.getState().mission.programs[0]?.vertices.find((one) => one.id === id)?.settings[name];
const text = (id: string) => page.find(`vertex-${id}`).textContent;
const isFocused = (testId: string) => expect(document.activeElement).toBe(page.find(testId));
const control = (name: string) => page.place.querySelector<HTMLElement>(`[role="slider"][aria-label="${name}"]`);

beforeEach(async () => {
  page = await mountGraph(missionOf(PROGRAM), <Inspector />, MEASURED);
});
afterEach(() => leaveGraph(page));

describe("under its vertex", () => {
  async function openByDoubleClick(id: string, of = ".box"): Promise<HTMLInputElement> {
    const at = page.find(`vertex-${id}`).querySelector(of);
    page.act(() => at?.dispatchEvent(new MouseEvent("dblclick", { bubbles: true })));
    await page.until(() => expect(page.has("in-place")).toBe(true));
    const field = page.find("in-place").querySelector("input[type=text]");
    expect(document.activeElement).toBe(field);
    return field as HTMLInputElement;
  }

  it("values stand with their unit", () => {
    expect([text("turn"), text("wait")]).toEqual([expect.stringContaining("90°"), expect.stringContaining("1.0 s")]);
    expect(text("when")).toContain("Sign < 20 cm");
  });

  it("a digit is typed over the value of what is selected, Enter keeps it and the graph has the keys again", async () => {
    page.click("vertex-turn");
    await page.key("1");
    await page.until(() => expect(page.has("in-place")).toBe(true));
    await page.type("180");
    await page.key("Enter");
    expect([setting("turn", "angle"), page.has("in-place")]).toEqual(["50", false]);
    isFocused("canvas");
  });

  it("Escape leaves the value as it was, and no step of undo", async () => {
    await openByDoubleClick("wait");
    await page.type("2.5 s");
    expect(setting("wait", "time")).toBe("25");
    await page.key("Escape");
    expect([setting("wait", "time"), useStudio.getState().canUndo]).toEqual(["10", false]);
    isFocused("canvas");
  });

  it("what is out of the range is marked, told in one sentence, and Enter takes the nearest", async () => {
    await openByDoubleClick("turn");
    await page.type("400");
    expect(page.find("in-place").querySelector("[role=alert]")?.textContent).toBe("At most 360°. Enter keeps 360°.");
    expect(page.find("in-place").querySelector(".field-number.is-wrong")).not.toBeNull();
    await page.key("Enter");
    expect(setting("turn", "angle")).toBe("100");
  });

  it("the number of a test is edited on its chip", async () => {
    await openByDoubleClick("when", ".chip");
    await page.type("35");
    await page.key("Enter");
    expect(setting("near", "value")).toBe("35");
  });
});

describe("in the inspector", () => {
  async function select(id: string): Promise<void> {
    page.act(() => useStudio.getState().select([id]));
    await page.until(() => expect(page.has("inspector")).toBe(true));
  }
  async function keys(name: string, ...pressed: string[]): Promise<void> {
    page.act(() => control(name)?.focus());
    for (const key of pressed) await page.key(key);
  }

  it("a part has its name, that of LLL, and what was said of the value", async () => {
    await select("turn");
    expect(page.find("inspector").querySelector(".inspector-element")?.textContent).toBe("Motor.AbsoluteTurn");
    expect(page.find("inspector").textContent).toContain("a quarter turn");
  });

  it("a number that is marked to vary says its address, as the command line takes it, with its values", async () => {
    chooseSimple(false);
    await select("turn");
    const marked = () => [...page.find("inspector").querySelectorAll("code")].map((one) => one.textContent);
    expect(page.find("vary-p.turn.angle").title).toContain("p.turn.angle");
    page.click("vary-p.turn.angle");
    expect(marked()).toContain("p.turn.angle");
    page.act(() => setValues("p.turn.angle", "10,20"));
    expect(marked()).toContain("p.turn.angle=10,20");
    page.click("vary-p.turn.angle");
    expect(marked()).not.toContain("p.turn.angle=10,20");
  });

  it("an angle has a dial, with its steps, its ends, and Escape goes back to what was there", async () => {
    await select("turn");
    expect(control("angle")?.getAttribute("aria-valuetext")).toBe("90°");
    await keys("angle", "ArrowUp");
    expect(setting("turn", "angle")).toBe("26");
    await keys("angle", "PageDown");
    expect(setting("turn", "angle")).toBe("16");
    await keys("angle", "End");
    expect(setting("turn", "angle")).toBe("100");
    await keys("angle", "Home");
    expect(setting("turn", "angle")).toBe("0");
    await page.key("Escape");
    isFocused("canvas");
    expect([setting("turn", "angle"), useStudio.getState().canUndo]).toEqual(["25", false]);
  });

  it("a distance has a ruler", async () => {
    await select("near");
    expect(control("value")?.getAttribute("aria-valuetext")).toBe("20 cm");
    await keys("value", "PageUp");
    expect(setting("near", "value")).toBe("30");
  });

  it("in the list for a test, what the robot feels stands before what joins tests", async () => {
    await select("when");
    const groups = [...page.find("choose-when.condition").querySelectorAll("optgroup")].map((one) => one.label);
    expect([groups[0], groups.at(-1)]).toEqual(["Sign", "Conditions"]);
  });

  it("begins at its top with each part, and says when nothing or more than one is selected", async () => {
    await select("turn");
    page.act(() => useStudio.getState().select([]));
    expect(page.place.textContent).toContain("Nothing selected");
    page.act(() => useStudio.getState().select(["turn", "wait"]));
    expect(page.place.textContent).toContain("2 parts selected");
  });
});

describe("a breakpoint", () => {
  const breakpoints = () => useStudio.getState().mission.breakpoints ?? [];

  it("B sets it and takes it away; the inspector says when and from which visit on; each is undone", async () => {
    page.click("vertex-halt");
    await page.key("b");
    expect(breakpoints()).toMatchObject([{ program: "p", vertex: "halt" }]);
    expect(page.place.querySelectorAll(".breakpoint")).toHaveLength(1);
    await page.key("b");
    expect(breakpoints()).toEqual([]);
    await page.until(() => expect(page.has("breakpoint-switch")).toBe(true));
    page.click("breakpoint-switch");
    page.fill("breakpoint-hits", "2");
    page.press("breakpoint-hits", "Enter");
    page.fill("breakpoint-when", "Run.IsTrue()");
    page.press("breakpoint-when", "Enter");
    expect(breakpoints()).toEqual([{ program: "p", vertex: "halt", when: "Run.IsTrue()", hits: 2 }]);
    expect(page.place.querySelector<HTMLElement>(".breakpoint")?.dataset["more"]).toBe("true");
    for (let step = 0; step < 5; step++) page.undo();
    expect(breakpoints()).toEqual([]);
  });
});
