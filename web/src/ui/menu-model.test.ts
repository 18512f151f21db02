import { describe, expect, it } from "vitest";

import { firstItem, itemByLetter, type MenuEntry, menuItem, stepItem } from "./menu-model";

describe("a menu", () => {
  const item = (label: string) => menuItem(label, label, null, () => undefined);
  const entries: MenuEntry[] = [
    { kind: "heading", id: "h", label: "Head" },
    item("Open"),
    { kind: "line", id: "l" },
    item("Save"),
    item("Save as"),
  ];

  it("begins at the first item that can be chosen", () => {
    const none = menuItem("none", "None", null, () => undefined, true);
    expect(firstItem([{ kind: "line", id: "l" }, none, item("Save")])).toBe(2);
    expect(firstItem([none, none])).toBe(0);
    expect(firstItem([])).toBe(-1);
  });

  it("walks over its items round and round", () => {
    expect(stepItem(entries, -1, 1)).toBe(1);
    expect(stepItem(entries, 1, 1)).toBe(3);
    expect(stepItem(entries, 4, 1)).toBe(1);
    expect(stepItem(entries, -1, -1)).toBe(4);
    expect(stepItem(entries, 1, -1)).toBe(4);
  });

  it("finds items by their first letter, one after another", () => {
    expect(itemByLetter(entries, -1, "s")).toBe(3);
    expect(itemByLetter(entries, 3, "S")).toBe(4);
    expect(itemByLetter(entries, 4, "s")).toBe(3);
    expect(itemByLetter(entries, 0, "x")).toBe(-1);
  });

  it("without items has nowhere to go", () => expect(stepItem([{ kind: "line", id: "l" }], -1, 1)).toBe(-1));
});
