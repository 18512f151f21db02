import { afterEach, expect, it } from "vitest";

import { speak } from "../i18n/words";
import { mount, type Mounted } from "../testing/hooks";
import { TabList } from "./TabList";

const NAMES = ["one", "two", "three"] as const;
let page: Mounted | null = null;
const shown: string[] = [];

function open(name: (typeof NAMES)[number]): HTMLElement {
  shown.length = 0;
  page = mount(
    <TabList label="Numbers" id="n" names={NAMES} open={name} show={(to) => shown.push(to)} controls="p" className="">
      {(one) => one}
    </TabList>,
  );
  const row = page.place.querySelector<HTMLElement>("[role=tablist]");
  if (row === null) throw new Error("there is no row of tabs");
  return row;
}

function press(row: HTMLElement, key: string): void {
  row.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
}

afterEach(async () => {
  page?.end();
  await speak("en");
});

it("has one tab in the order of Tab: the open one", () => {
  const tabs = [...open("two").querySelectorAll<HTMLElement>("[role=tab]")];
  expect(tabs.map((tab) => [tab.id, tab.tabIndex, tab.ariaSelected ?? tab.getAttribute("aria-selected")])).toEqual([
    ["n-one", -1, "false"],
    ["n-two", 0, "true"],
    ["n-three", -1, "false"],
  ]);
});

it.each([
  ["ArrowRight", "three", "en"],
  ["ArrowLeft", "one", "en"],
  ["ArrowRight", "one", "ur"],
  ["ArrowLeft", "three", "ur"],
  ["Home", "one", "ur"],
  ["End", "three", "en"],
] as const)("%s leads from the second of three to the tab %s in the language %s", async (key, name, language) => {
  await speak(language);
  press(open("two"), key);
  expect(shown).toEqual([name]);
  expect(document.activeElement?.id).toBe(`n-${name}`);
});

it("goes round, and leaves other keys alone", () => {
  press(open("three"), "ArrowRight");
  expect(shown).toEqual(["one"]);
  page?.end();
  press(open("three"), "Enter");
  expect(shown).toEqual([]);
});
