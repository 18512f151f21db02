/** Notes are written where they stand, and kept however their field is left; only Escape forgets what was typed. */
import { afterEach, beforeEach, expect, it } from "vitest";

import { CARRIER, missionOf } from "../../model/testing/missions";
import { noteText } from "../../model/notes";
import { useStudio } from "../../model/studio";
import { type Graph, leaveGraph, mountGraph } from "../../testing/graph";

let page: Graph;
const noteOf = (id: string) =>
  noteText(useStudio.getState().mission.programs[0]?.vertices.find((one) => one.id === id)?.notes ?? []);
const strip = (id: string) => page.all(`note-${id}`)[0]?.textContent;

beforeEach(async () => {
  page = await mountGraph(missionOf(CARRIER, { ...CARRIER, name: "other" }));
});
afterEach(() => {
  leaveGraph(page);
});

async function write(id: string, text: string): Promise<void> {
  page.click(`vertex-${id}`);
  await page.key("n");
  await page.until(() => expect(document.activeElement).toBe(page.find("note-field")));
  await page.type(text);
}

it("N writes a note of several lines, which stands on its vertex, and undo takes it away", async () => {
  await write("v13", "Stand still\nuntil the road is free");
  await page.key("Enter");
  expect(noteOf("v13")).toBe("Stand still\nuntil the road is free");
  expect(strip("v13")).toBe("Stand still+1 line");
  expect(document.activeElement).toBe(page.find("canvas"));
  page.undo();
  expect(strip("v13")).toBeUndefined();
  page.act(() => useStudio.getState().redo());
  expect(strip("v13")).toContain("Stand still");
});

it("a click on a note opens it, Escape leaves it as it was, and emptied it is gone", async () => {
  await write("v13", "First");
  await page.key("Enter");
  page.click("note-v13");
  await page.until(() => expect(page.find<HTMLTextAreaElement>("note-field").value).toBe("First"));
  await page.type("Forgotten");
  await page.key("Escape");
  expect([noteOf("v13"), page.has("note-field")]).toEqual(["First", false]);
  page.click("note-v13");
  await page.type("");
  await page.key("Enter");
  expect([noteOf("v13"), strip("v13")]).toEqual(["", undefined]);
});

it("what was typed is kept by a click elsewhere, and by another program", async () => {
  await write("v13", "Kept by a click");
  page.act(() => page.find("note-field").blur());
  expect([noteOf("v13"), page.has("note-field")]).toEqual(["Kept by a click", false]);
  await write("v6", "Half a thought");
  page.act(() => useStudio.getState().setActiveProgram("other"));
  expect(noteOf("v6")).toBe("Half a thought");
});

it("the menu writes a note, in any script, and offers to remove it only where there is one", async () => {
  const open = () =>
    page.act(() => page.find("vertex-v13").dispatchEvent(new MouseEvent("contextmenu", { bubbles: true })));
  open();
  await page.until(() => expect(page.has("menu-context-note")).toBe(true));
  expect(page.has("menu-context-unnote")).toBe(false);
  page.click("menu-context-note");
  await page.until(() => expect(document.activeElement).toBe(page.find("note-field")));
  await page.type("یہاں رکو");
  await page.key("Enter");
  expect(page.find("note-v13").getAttribute("dir")).toBe("auto");
  expect(strip("v13")).toContain("یہاں رکو");
  open();
  await page.until(() => expect(page.has("menu-context-unnote")).toBe(true));
  page.click("menu-context-unnote");
  expect(strip("v13")).toBeUndefined();
});

it("Start has no note", async () => {
  page.click("vertex-start");
  await page.key("n");
  expect(page.has("note-field")).toBe(false);
});
