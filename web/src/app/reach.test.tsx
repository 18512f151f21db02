/** Every entry of every menu is reached by keys and is in the list of keys; F1 and the outline explain the program. */
import { afterEach, beforeEach, describe, expect, it } from "vitest";

import { CARRIER, missionOf } from "../model/testing/missions";
import { useStudio } from "../model/studio";
import { MENUS } from "../session/menu-table";
import { Outline } from "../features/accessibility/Outline";
import { PartHelp } from "../features/accessibility/PartHelp";
import { Announcer } from "../features/accessibility/Announcer";
import { closeHelp, closeOutline } from "../features/accessibility/state";
import { Palette } from "../features/palette/Palette";
import { type Graph, leaveGraph, mountGraph } from "../testing/graph";
import { MenuBar } from "./MenuBar";
import { useMenus } from "./menus";
import { ShortcutsSheet } from "./Shortcuts";
import { Tabs } from "./Tabs";
import { useRenaming } from "./tab-rename";

function Menus() {
  return <MenuBar menus={useMenus()} />;
}

let page: Graph;
const focused = () => document.activeElement;
const programs = () => useStudio.getState().mission.programs.map(({ name }) => name);
const active = () => useStudio.getState().activeProgram;

beforeEach(async () => {
  page = await mountGraph(
    missionOf(CARRIER, { ...CARRIER, name: "loader" }),
    <>
      <Menus />
      <Tabs />
      <Palette />
      <div id="canvas-panel" />
      <Outline />
      <PartHelp />
      <Announcer />
    </>,
  );
});
afterEach(() => {
  page.act(() => {
    closeHelp();
    closeOutline();
  });
  leaveGraph(page);
  useRenaming.setState({ program: null });
});

describe("the menus", () => {
  it.each(MENUS.map(({ id }) => id))("%s: arrows reach each entry, and the list of keys has it", async (id) => {
    const sheet = await mountSheet();
    page.act(() => page.find(`menu-${id}`).click());
    const entries = [...document.querySelectorAll<HTMLElement>('[role=menu] [role^="menuitem"]')];
    expect(entries.length).toBeGreaterThan(0);
    const seen = new Set<Element | null>();
    for (let step = 0; step <= entries.length; step++) {
      seen.add(focused());
      await page.key("ArrowDown");
    }
    // What cannot be chosen now can be reached all the same.
    expect(entries.filter((entry) => !seen.has(entry)).map((entry) => entry.dataset["testid"])).toEqual([]);
    for (const entry of entries) {
      const key = entry.querySelector(".menu-keys")?.textContent;
      const label = entry.querySelector(".menu-label")?.textContent ?? "";
      if (key == null) expect(sheet.words, label).toContain(label);
      else expect(sheet.keys).toContain(key);
    }
    await page.key("Escape");
  });

  async function mountSheet() {
    const { mount } = await import("../testing/hooks");
    const sheet = mount(<ShortcutsSheet />);
    const keys = [...sheet.place.querySelectorAll(".keys:not(.keys-paths) kbd")].map((one) => one.textContent);
    const words = sheet.place.textContent;
    sheet.end();
    return { keys, words };
  }
});

describe("programs by keys", () => {
  it("are walked round, moved, renamed in their tab and removed; each undone", async () => {
    page.act(() => page.find("canvas").focus());
    await page.key("PageDown", { altKey: true });
    expect(active()).toBe("loader");
    await page.key("PageUp", { altKey: true });
    await page.key("PageUp", { altKey: true });
    expect(active()).toBe("loader");
    await page.key("PageUp", { altKey: true, shiftKey: true });
    expect(programs()).toEqual(["loader", "carrier"]);
    await page.key("z", { ctrlKey: true });
    expect(programs()).toEqual(["carrier", "loader"]);
    await page.key("F2");
    await page.until(() => expect(focused()).toBe(page.find("tab-name-field")));
    await page.type("driver");
    page.press("tab-name-field", "Enter");
    expect(programs()).toContain("driver");
    page.act(() => page.find("tab-driver").focus());
    await page.key("Delete");
    expect(programs()).toEqual(["carrier"]);
    page.undo();
    expect(programs()).toContain("driver");
  });

  it("and team and world stand in the same row, which arrows, Home and End walk", async () => {
    page.act(() => page.find("tab-carrier").focus());
    await page.key("End");
    expect(focused()).toBe(page.find("tab-of-world"));
    await page.key("ArrowLeft");
    expect(focused()).toBe(page.find("tab-of-team"));
    await page.key("Home");
    expect(focused()).toBe(page.find("tab-carrier"));
  });
});

describe("help and outline", () => {
  it("F1 explains the part that has the focus, with its range, and gives the focus back", async () => {
    const part = page.find("part-Wheel.Advance");
    page.act(() => part.focus());
    await page.key("F1");
    await page.until(() => expect(page.has("part-help")).toBe(true));
    expect(page.find("part-help").textContent).toContain("Drives forward until Stop.");
    expect(page.find("part-help").textContent).toContain("from 0 % to 100 %");
    page.press("part-help", "Escape");
    expect([page.has("part-help"), focused()]).toEqual([false, part]);
  });

  it("the outline is walked into bodies and out, deletes, and Escape gives the graph back", async () => {
    await page.key("F4");
    await page.until(() => expect(page.has("outline")).toBe(true));
    const rows = () => [...page.find("outline").querySelectorAll<HTMLElement>("[role=treeitem]")];
    expect(focused()).toBe(rows()[0]);
    await page.key("ArrowDown");
    expect([focused() === rows()[1], rows()[1]?.getAttribute("aria-selected")]).toEqual([true, "true"]);
    await page.key("ArrowRight");
    expect([focused() === rows()[2], rows()[2]?.getAttribute("aria-level")]).toEqual([true, "2"]);
    await page.key("ArrowLeft");
    await page.key("Delete");
    const said = () => page.place.querySelector('[aria-live="polite"]')?.textContent;
    expect(useStudio.getState().mission.programs[0]?.vertices.length).toBeLessThan(5);
    await page.until(() => expect(said()).not.toBe(""));
    await page.key("z", { ctrlKey: true });
    await page.until(() => expect(said()).toContain("Undone"));
    await page.key("Escape");
    expect(page.has("outline")).toBe(false);
    expect(focused()).toBe(page.find("canvas"));
  });
});

describe("what happens is said", () => {
  const said = () => page.place.querySelector('[aria-live="polite"]')?.textContent ?? "";
  const hears = (words: string) => page.until(() => expect(said()).toContain(words));

  it("what was done, undone and done again; a selected arc; how many parts are selected; what was found", async () => {
    page.click("part-Wait");
    await hears("Add Wait");
    await page.key("z", { ctrlKey: true });
    await hears("Undone: Add Wait");
    await page.key("y", { ctrlKey: true });
    await hears("Done again: Add Wait");
    page.click("vertex-v13");
    expect(page.find("canvas").getAttribute("aria-activedescendant")).toBe("vertex-v13");
    expect(page.find("vertex-v13").getAttribute("aria-label")).toContain("Stop");
    await page.key("a");
    await hears("Arc after");
    await page.key("ArrowUp");
    await page.key("ArrowDown", { shiftKey: true });
    await hears("2 parts selected");
    await page.key("f", { ctrlKey: true });
    await page.until(() => expect(focused()).toBe(page.find("find-input")));
    await page.type("lamp light off");
    await page.key("Enter");
    await hears("Selected: ");
  });
});
