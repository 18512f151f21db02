import { afterEach, beforeEach, describe, expect, it } from "vitest";

import { moreWords, speak, t } from "../i18n/words";
import { mount, type Mounted } from "../testing/hooks";
import "./features";
import { ShortcutsSheet } from "./Shortcuts";

let page: Mounted;
const before = document.createElement("button");
beforeEach(async () => {
  await speak("en");
  await moreWords();
  document.body.append(before);
  before.focus();
  page = mount(<ShortcutsSheet />);
});
afterEach(() => {
  page.end();
  before.remove();
});

const field = () => page.place.querySelector<HTMLInputElement>('[data-testid="keys-find"]');
const lines = () => [...page.place.querySelectorAll("dl div")].map((line) => line.textContent);
function type(words: string): void {
  page.act(() => {
    const input = field();
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(input, words);
    input?.dispatchEvent(new Event("input", { bubbles: true }));
  });
}

describe("the sheet of keys", () => {
  it("has the focus in its field, and gives it back", () => {
    expect(document.activeElement).toBe(field());
    page.end();
    expect(document.activeElement).toBe(before);
    page = mount(<ShortcutsSheet />);
  });

  it("leaves what holds all words, in a key or in its meaning", () => {
    const all = lines().length;
    type("words OUTLINE");
    expect(lines()).toEqual([expect.stringContaining(t("help.keys-outline"))]);
    type("f9 ctrl");
    expect(lines()).toEqual([expect.stringContaining(t("run.step-vertex-back"))]);
    type(" ");
    expect(lines()).toHaveLength(all);
  });

  it.each([
    ["breakpoint", "debug.toggle"],
    ["full screen", "arena.large"],
    ["zoom", "graph.fit"],
    ["joystick", "elsewhere.gamepad"],
    ["trace", "elsewhere.timeline"],
    ["merge", "elsewhere.merge"],
    ["diff", "elsewhere.merge"],
  ] as const)("finds by a word of the field what has a plain label: %s", (word, says) => {
    type(word);
    expect(lines()).toContainEqual(expect.stringContaining(t(says)));
    expect(lines().length).toBeLessThan(8);
  });

  it("shows other words only where they are why a line was found", () => {
    expect(page.place.querySelector(".keys-also")).toBeNull();
    type("breakpoint");
    expect(page.place.querySelector(".keys-also")?.textContent).toBe(t("search.breakpoint"));
    type("pause here");
    expect(page.place.querySelector(".keys-also")).toBeNull();
  });

  it("says that nothing was found, and the first Escape empties the field", () => {
    type("xyzzy");
    expect(lines()).toEqual([]);
    expect(page.place.querySelector('[role="status"]')?.textContent).toBe(t("help.keys-none", { query: "xyzzy" }));
    page.act(() => field()?.dispatchEvent(new KeyboardEvent("keydown", { key: "Escape", bubbles: true })));
    expect(field()?.value).toBe("");
    expect(lines().length).toBeGreaterThan(50);
  });

  it.each([
    ["fr", "retablir", "help.keys-redo"],
    ["fr", "point d'arrêt", "debug.toggle"],
    ["fr", "breakpoint", "debug.toggle"],
    ["ur", "breakpoint", "debug.toggle"],
    ["ur", "روکو", "help.keys-pause"],
  ] as const)("searches in the language of the page: %s", async (language, word, says) => {
    page.end();
    await speak(language);
    await moreWords();
    page = mount(<ShortcutsSheet />);
    type(word);
    expect(lines()).toContainEqual(expect.stringContaining(t(says)));
    expect(lines().length).toBeLessThan(5);
  });
});
