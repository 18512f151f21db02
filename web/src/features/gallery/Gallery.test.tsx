/** The examples: found by words, level, topic and robot; walked by arrows; pictures that move while they are seen. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import * as client from "../../api/client";
import type { MissionEntry, RunPreview, World } from "../../api/generated";
import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { useDocument } from "../../session/document";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted, settle } from "../../testing/hooks";
import { Examples } from "./Examples";
import { Gallery, usePlays } from "./Gallery";

await moreWords();

function entry(name: string, level: number, topic: string, robots: string[]): MissionEntry {
  const example = { level, topics: [{ name: topic, label: { "": topic } }], robots, agents: 1, parts: 3 };
  const words = { label: { "": name }, help: { "": `It ${name}s.` } };
  return {
    path: `example:${name}/${name}.krt`,
    name,
    title: "",
    modified: name,
    problem: "",
    ...words,
    example,
  };
}
const ROOM: World = {
  ...{ name: "w", width_mm: 9, height_mm: 9, walls: [], floors: [], lines: [], roads: [] },
  ...{ docks: [], storehouses: [], starts: [] },
};
const EXAMPLES = [
  entry("square", 1, "moving", ["carrier"]),
  entry("blink", 1, "lights", ["microbit"]),
  entry("convoy", 3, "teams", ["carrier"]),
];

const chosen = vi.fn();
let page: Mounted;
let hands: Hands;
let seen: ((isIntersecting: boolean) => void)[];

beforeEach(() => {
  chosen.mockClear();
  localStorage.clear();
  usePlays.setState({ on: true });
  useStudio.getState().openMission(fileOf(missionOf(CARRIER)));
  seen = [];
  vi.stubGlobal(
    "IntersectionObserver",
    class {
      constructor(said: (entries: { isIntersecting: boolean }[]) => void) {
        seen.push((isIntersecting) => said([{ isIntersecting }]));
      }
      observe = vi.fn();
      disconnect = vi.fn();
    },
  );
  page = mount(<Gallery examples={EXAMPLES} open={chosen} />);
  hands = handsOn(page);
});
afterEach(() => {
  page.end();
  usePlays.setState({ on: true });
  localStorage.clear();
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

const cards = () => [...page.place.querySelectorAll<HTMLElement>(".card")];
const names = () => cards().map(({ dataset }) => dataset["testid"]?.replace("example-", ""));
const press = (on: Element | null | undefined, key: string) =>
  page.act(() => on?.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true })));

it("stand from the easiest to the hardest, and are found by level, topic and robot", () => {
  expect([...page.place.querySelectorAll("h4")].map(({ textContent }) => textContent)).toEqual(["Easy", "For experts"]);
  hands.click("gallery-level-3");
  expect(names()).toEqual(["convoy"]);
  hands.click("gallery-level-0");
  hands.click("gallery-topic-lights");
  expect([names(), hands.find("gallery-count").textContent]).toEqual([["blink"], "1 example"]);
  hands.choose("gallery-robot", "carrier");
  expect([names(), hands.find("gallery-count").textContent]).toEqual([[], "No example is like that."]);
  hands.click("gallery-show-all");
  expect(names()).toHaveLength(3);
});

it("are found by words; Escape empties the field, and the arrows lead from it to the cards and back", () => {
  const find = hands.find<HTMLInputElement>("gallery-find");
  hands.fill("gallery-find", "it  blinks");
  expect(names()).toEqual(["blink"]);
  press(find, "Escape");
  expect([find.value, names().length]).toEqual(["", 3]);
  press(find, "ArrowDown");
  expect(document.activeElement).toBe(cards()[0]);
  press(cards()[0], "ArrowUp");
  expect(document.activeElement).toBe(find);
  hands.fill("gallery-find", "convoy");
  press(find, "Enter");
  expect(document.activeElement).toBe(cards()[0]);
  page.act(() => cards()[0]?.click());
  expect(chosen).toHaveBeenCalledWith(EXAMPLES[2]);
});

it("a picture is fetched as it comes into sight and moves while it is seen, unless somebody wants it still", async () => {
  const preview: RunPreview = {
    ...{ world: ROOM, seconds: 1, frames: 9, agents: [], ways: [], program: null },
    ...{ shown: [], stock: [], things: [], pens: [], marks: [] },
  };
  const ask = vi.spyOn(client, "ask").mockResolvedValue(preview);
  const pen = { setTransform: vi.fn() };
  vi.spyOn(HTMLCanvasElement.prototype, "getContext").mockReturnValue(pen as never);
  vi.stubGlobal(
    "ResizeObserver",
    class {
      observe = vi.fn();
      disconnect = vi.fn();
    },
  );
  expect(ask).not.toHaveBeenCalled();
  await settle(() => seen[0]?.(true));
  await settle();
  const moves = () => cards()[0]?.querySelector("canvas")?.dataset["moves"];
  const sight = seen.at(-1);
  page.act(() => sight?.(true));
  expect([ask.mock.calls.length, moves()]).toEqual([1, "true"]);
  page.act(() => sight?.(false));
  expect(moves()).toBe("false");
  hands.click("gallery-plays");
  page.act(() => seen.at(-1)?.(true));
  expect([moves(), localStorage.getItem("kitrobot.gallery-still")]).toEqual(["false", "yes"]);
  // Under the focus it moves.
  page.act(() => cards()[0]?.focus());
  page.act(() => seen.at(-1)?.(true));
  expect(moves()).toBe("true");
});

it("under an empty program stand the easiest ones and the last, with their sizes, and the way to all", async () => {
  page.end();
  const more = ["a", "b", "c"].map((name) => entry(name, 2, "moving", ["carrier"]));
  vi.spyOn(client.api, "missions").mockResolvedValue([...EXAMPLES.slice(0, 2), ...more, ...EXAMPLES.slice(2)]);
  const opened = vi.spyOn(client.api, "mission").mockReturnValue(new Promise(() => undefined));
  await settle(() => {
    page = mount(<Examples />);
  });
  hands = handsOn(page);
  expect(names()).toEqual(["square", "blink", "a", "convoy"]);
  expect(cards()[0]?.textContent).toContain("3 parts");
  hands.click("all-examples");
  expect(useDocument.getState().overlay).toBe("open");
  page.act(() => cards()[0]?.click());
  await vi.waitFor(() => expect(opened).toHaveBeenCalledWith("example:square/square.krt"));
  useDocument.setState(useDocument.getInitialState());
});
