import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { mount, type Mounted } from "../testing/hooks";
import type { MenuPart } from "../ui/menu-model";
import { MenuBar } from "./MenuBar";

const chosen = vi.fn<(id: string) => void>();

const MENUS: MenuPart[] = ["File", "Edit"].map((id) => ({
  id,
  label: id,
  entries: [
    { kind: "item", id: `${id}-one`, label: "One", run: () => chosen(`${id}-one`) },
    { kind: "line", id: `${id}-line` },
    { kind: "item", id: `${id}-off`, label: "Off", disabled: true, run: () => chosen(`${id}-off`) },
    { kind: "check", id: `${id}-two`, label: "Two", checked: true, run: () => chosen(`${id}-two`) },
  ],
}));

let page: Mounted;
beforeEach(() => {
  chosen.mockClear();
  page = mount(<MenuBar menus={MENUS} />);
});
afterEach(() => page.end());

const focused = () => document.activeElement?.getAttribute("data-testid");
const find = (id: string) => page.place.querySelector<HTMLElement>(`[data-testid="menu-${id}"]`);
function press(...keys: string[]): void {
  for (const key of keys) {
    page.act(() => {
      document.activeElement?.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
    });
  }
}
function click(id: string): void {
  page.act(() => find(id)?.click());
}
function alt(): void {
  page.act(() => {
    document.activeElement?.dispatchEvent(new KeyboardEvent("keydown", { key: "Alt", bubbles: true }));
    document.activeElement?.dispatchEvent(new KeyboardEvent("keyup", { key: "Alt", bubbles: true }));
  });
}

describe("the menu bar", () => {
  it("is reached by Alt and left by Alt", () => {
    alt();
    expect(focused()).toBe("menu-File");
  });

  it("opens a menu on its first item and walks down", () => {
    alt();
    press("ArrowDown");
    expect(focused()).toBe("menu-File-one");
    press("ArrowDown", "ArrowDown");
    expect(focused()).toBe("menu-File-two");
    press("ArrowDown");
    expect(focused()).toBe("menu-File-one");
  });

  it("does what is chosen, closes, and gives the focus back to its title", () => {
    click("File");
    press("ArrowUp", "Enter");
    expect(chosen).toHaveBeenCalledWith("File-two");
    expect(find("File-one")).toBeNull();
    expect(focused()).toBe("menu-File");
  });

  it("goes to the neighbour menu with the arrows", () => {
    click("File");
    press("ArrowRight");
    expect(focused()).toBe("menu-Edit-one");
    press("ArrowRight");
    expect(focused()).toBe("menu-File-one");
  });

  it("closes on Escape without doing anything", () => {
    click("Edit");
    press("Escape");
    expect(find("Edit-one")).toBeNull();
    expect(chosen).not.toHaveBeenCalled();
  });

  it("closes on a click elsewhere", () => {
    click("File");
    page.act(() => document.body.dispatchEvent(new Event("pointerdown", { bubbles: true })));
    expect(find("File-one")).toBeNull();
  });

  it("does nothing for what cannot be chosen now", () => {
    click("File");
    click("File-off");
    expect(chosen).not.toHaveBeenCalled();
  });

  it("says roles and states", () => {
    click("File");
    expect(find("File")?.getAttribute("aria-expanded")).toBe("true");
    expect(find("File-two")?.getAttribute("role")).toBe("menuitemcheckbox");
    expect(find("File-two")?.getAttribute("aria-checked")).toBe("true");
    expect(find("File-off")?.getAttribute("aria-disabled")).toBe("true");
  });
});
