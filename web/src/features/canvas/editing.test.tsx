/** A program is drawn with keys, menus and drags: each is one step, which undo takes back. */
import { afterEach, beforeEach, describe, expect, it } from "vitest";

import { emptyProgram } from "../../model/commands/changePrograms";
import { CARRIER, missionOf } from "../../model/testing/missions";
import { useStudio } from "../../model/studio";
import type { Point } from "../../model/layout";
import type { Program } from "../../model/types";
import { lllOf } from "../../model/lll";
import { beginDrag, useDrag } from "../../session/drag";
import { currentDrawing } from "../../session/drawing";
import { type Graph, leaveGraph, middleOf, middleOfArc, mountGraph } from "../../testing/graph";

/** A part of the palette, without the palette. */
function Part({ element }: { element: string }) {
  return <i data-testid={`part-${element}`} onPointerDown={(event) => beginDrag(event, { kind: "part", element })} />;
}

let page: Graph;
const program = () => useStudio.getState().mission.programs[0] as Program;
const count = (element: string) => program().vertices.filter((one) => one.element === element).length;
const selected = () => useStudio.getState().selection;
/** The program in view as LLL, without spaces. */
const lll = () => lllOf(currentDrawing()?.structure.main.chain ?? []).replace(/\s+/g, "");
const parked = () => (currentDrawing()?.structure.parked ?? []).map((chain) => chain[0]?.vertex.element);
const isFocused = (testId: string) => expect(document.activeElement).toBe(page.find(testId));

async function show(...programs: Program[]): Promise<void> {
  const parts = ["Wait", "If Then", "And", "Cargo.IsPressed", "Repetition"];
  page = await mountGraph(
    missionOf(...programs),
    parts.map((element) => <Part key={element} element={element} />),
  );
}
const part = (element: string) => page.find(`part-${element}`);
const vertex = (id: string) => page.find(`vertex-${id}`);

afterEach(() => leaveGraph(page));

async function drag(from: Element, to: Point, held?: PointerEventInit): Promise<void> {
  await page.carry(from, to, held);
  await page.drop(to, held);
}

async function add(words: string, open = "/"): Promise<void> {
  await page.key(open);
  isFocused("add-find");
  await page.type(words);
  await page.key("Enter");
}

describe("by keys alone", () => {
  beforeEach(() => show(emptyProgram("p", "carrier")));

  it("parts are added, into the body of one by its arc, moved out of it and past it, and wrapped", async () => {
    await add("repet");
    expect(lll()).toBe("10*();");
    await page.key("a");
    await add("wait");
    expect(lll()).toBe("10*(WAIT(10););");
    await page.key("ArrowDown", { altKey: true });
    expect(lll()).toBe("10*();WAIT(10);");
    await page.key("ArrowUp", { altKey: true });
    await page.key("ArrowUp", { altKey: true });
    expect(lll()).toBe("WAIT(10);10*();");
    await page.key("ArrowDown", { shiftKey: true });
    expect(selected()).toHaveLength(2);
    await add("while", "w");
    expect(lll()).toBe("*[](WAIT(10);10*(););");
  });

  it("the empty program and an empty body say where a part goes, and what follows a loop goes inside", async () => {
    await page.until(() => expect(page.has("first-place")).toBe(true));
    await add("while");
    expect(page.all("place-*").map((one) => one.textContent)).toEqual([
      expect.stringContaining("Drop here what repeats"),
    ]);
    await add("repet");
    expect(lll()).toBe("*[](10*(););");
    expect(page.all("place-*")).toHaveLength(1);
  });
});

describe("by a menu", () => {
  beforeEach(() => show(CARRIER));

  it("the secondary button works on what is under it, which it selects first", async () => {
    await page.rightClick("vertex-v13");
    expect(selected()).toEqual(["v13"]);
    page.click("menu-context-duplicate");
    expect(count("Wheel.Stop")).toBe(2);
    page.undo();
    await page.rightClick("vertex-v13");
    page.click("menu-context-delete");
    expect(count("Wheel.Stop")).toBe(0);
    page.undo();
    await page.rightClick("arc-start.next");
    page.click("menu-context-add");
    isFocused("add-find");
  });

  it("keys open that of the selected part, letters go to its entries, and Escape gives the graph back", async () => {
    page.click("vertex-v13");
    await page.key("F10", { shiftKey: true });
    expect(page.has("context-menu")).toBe(true);
    await page.key("Escape");
    expect(page.has("context-menu")).toBe(false);
    isFocused("canvas");
    await page.key("ContextMenu");
    await page.key("D");
    await page.key("Enter");
    expect(count("Wheel.Stop")).toBe(2);
  });

  it.each(["vertex", "arc", "canvas"])("every entry of that of a %s is reached by the arrows", async (of) => {
    if (of === "vertex") page.click("vertex-v13");
    if (of === "arc") await page.key("a");
    await page.key("F10", { shiftKey: true });
    const entries = page.all("menu-context-*").filter((one) => one.getAttribute("role") === "menuitem");
    expect(entries.length).toBeGreaterThan(1);
    const seen = new Set<Element | null>();
    while (!seen.has(document.activeElement)) {
      seen.add(document.activeElement);
      await page.key("ArrowDown");
    }
    expect([...seen]).toEqual(expect.arrayContaining(entries));
  });

  it("W offers what goes around the selection, and Shift+W takes it away again", async () => {
    const before = lll();
    page.click("vertex-v20");
    await page.key("w");
    await page.type("w");
    expect([page.has("add-Wait"), page.has("add-While")]).toEqual([false, true]);
    await page.type("if");
    await page.key("Enter");
    expect(lll()).toContain("[](Lamp.LightOff(););");
    await page.key("W", { shiftKey: true });
    expect(lll()).toBe(before);
  });

  it("keys mean the same on a keyboard of another script", async () => {
    page.click("vertex-v13");
    await page.key("ن", { code: "KeyN" });
    await page.until(() => isFocused("note-field"));
  });
});

describe("by a drag", () => {
  beforeEach(() => show(CARRIER));
  const accepts = () => page.find("canvas").dataset["accepts"];
  const aimed = () => [...document.querySelectorAll<HTMLElement>(".arc.is-aimed")].map((one) => one.dataset["arc"]);

  it("arcs light up, and a part of the palette is spliced into the one that it is dropped on", async () => {
    await page.carry(part("Wait"), middleOfArc("start.next"));
    expect([accepts(), aimed()]).toEqual(["arcs", ["start.next"]]);
    expect(document.querySelector(".ghost")?.textContent).toContain("Wait");
    await page.drop(middleOfArc("start.next"));
    expect(lll()).toMatch(/^WAIT\(10\);\*\[Run/);
    page.undo();
    expect(program()).toEqual(CARRIER);
  });

  it("Escape ends it without a change", async () => {
    await page.carry(part("Wait"), middleOfArc("start.next"));
    await page.key("Escape");
    expect([useDrag.getState().payload, document.querySelector(".ghost")]).toEqual([null, null]);
    expect(useStudio.getState().dirty).toBe(false);
  });

  it("what is dropped beside everything is aside, no part of the program, until it is dragged in", async () => {
    const before = lll();
    await page.carry(part("Wait"), { x: 30, y: 800 });
    expect(document.querySelector(".ghost")?.textContent).toContain("aside");
    await page.drop({ x: 30, y: 800 });
    expect([parked(), lll()]).toEqual([["Wait"], before]);
    const [id = ""] = selected();
    await drag(vertex(id), middleOfArc("start.next"));
    expect([parked(), lll().startsWith("WAIT(10);")]).toEqual([[], true]);
  });

  it("a vertex goes with its body, and not into it; with Alt a copy goes", async () => {
    await drag(vertex("v18"), middleOfArc("v18.body"));
    expect(useStudio.getState().dirty).toBe(false);
    await drag(vertex("v18"), middleOfArc("start.next"));
    expect(lll()).toMatch(/^<Cargo.IsPressed\(\)>\(Lamp.LightOff\(\);\);/);
    expect([count("When"), count("Lamp.LightOff")]).toEqual([4, 1]);
    page.undo();
    expect(program()).toEqual(CARRIER);
    await drag(vertex("v18"), middleOfArc("start.next"), { altKey: true });
    expect([count("When"), count("Lamp.LightOff")]).toEqual([5, 2]);
  });

  it("a part that holds others goes around the selection that it is dropped on, and Shift+W unwraps", async () => {
    const before = lll();
    page.click("vertex-v20");
    await drag(part("Repetition"), middleOf("v20"));
    expect(lll()).toContain("10*(Lamp.LightOff(););");
    await page.key("W", { shiftKey: true });
    expect(lll()).toBe(before);
  });

  it("a box that is drawn with Shift beside everything selects what it touches, and the graph stays", () => {
    const pane = document.querySelector(".canvas-pane") as HTMLElement;
    const first = middleOf("v1");
    const at = (kind: string, x: number, y: number) =>
      new PointerEvent(kind, { bubbles: true, shiftKey: true, clientX: x, clientY: y });
    page.act(() => pane.dispatchEvent(new MouseEvent("mousedown", at("mousedown", 2, 2))));
    page.act(() => window.dispatchEvent(at("pointermove", 900, first.y + 5)));
    expect(document.querySelector(".marquee")).not.toBeNull();
    expect(selected()).toEqual(["v1"]);
    page.act(() => window.dispatchEvent(at("pointermove", 900, 830)));
    page.act(() => window.dispatchEvent(at("pointerup", 900, 830)));
    expect(document.querySelector(".marquee")).toBeNull();
    expect(selected().length).toBeGreaterThan(5);
    expect(middleOf("v1")).toEqual(first);
  });
});
