/** The path to learn as it is shown: in its order, with ticks, and with a way on. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { moreWords } from "../../i18n/words";
import { show, useDocument } from "../../session/document";
import { setOpenLesson, useLessons } from "../../session/lessons";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted } from "../../testing/hooks";
import { lesson, setPath } from "../../testing/lessons";
import { firstOpen, Invitation } from "./Invitation";
import { LearnSheet } from "./LearnSheet";

const begin = vi.fn();
const problem = { code: "", severity: "error", message: "a mistake", help: "", line: 3 } as never;
let page: Mounted;
let hands: Hands;
let end: () => void;

beforeEach(async () => {
  vi.stubGlobal(
    "IntersectionObserver",
    class {
      observe = vi.fn();
      disconnect = vi.fn();
    },
  );
  await moreWords();
  begin.mockClear();
  end = await setPath(
    lesson("c", 3, { usable: false, problems: [problem] }),
    lesson("b", 2, { kind: "exercise", begin, far: () => "4 goals" }),
    lesson("a", 1, { begin }),
  );
});
afterEach(() => {
  page.end();
  end();
  vi.unstubAllGlobals();
  show(null);
});

function open(tree = <LearnSheet />): void {
  page = mount(tree);
  hands = handsOn(page);
}
const cards = () => [...page.place.querySelectorAll(".learn-card")].map((card) => card.getAttribute("data-testid"));

it("tutorials and exercises stand in one order; the first that is open is marked, and Next leads there", () => {
  open();
  expect(cards()).toEqual(["tutorial-card-a", "exercise-card-b", "tutorial-card-c"]);
  expect(hands.find("tutorial-card-a").getAttribute("aria-current")).toBe("step");
  expect(hands.find("exercise-card-b").textContent).toContain("Exercise · 4 goals");
  expect(hands.find("learn-count").textContent).toBe("0 of 2 done");
  expect(hands.find("learn-next").textContent).toBe("Next: a");
  hands.click("learn-next");
  hands.click("exercise-card-b");
  expect(begin).toHaveBeenCalledTimes(2);
});

it("what is done has a tick, the mark goes on, and at last the whole path is praised", () => {
  open();
  page.act(() => setOpenLesson("tutorial", { name: "a", done: true }));
  expect(hands.find("tutorial-card-a").dataset["learned"]).toBe("true");
  expect(hands.find("exercise-card-b").getAttribute("aria-current")).toBe("step");
  expect(hands.find("learn-next").textContent).toBe("Next: b");
  page.act(() => setOpenLesson("exercise", { name: "b", done: true }));
  expect(hands.find("learn-count").textContent).toBe("You have done the whole path. Well done!");
  expect(hands.has("learn-next")).toBe(false);
});

it("one with a mistake says which and cannot be begun", () => {
  open();
  expect(hands.find("tutorial-card-c").textContent).toContain("a mistake");
  expect(hands.find("tutorial-card-c").tagName).toBe("DIV");
});

it("the doors lead to what is new and to what is there", () => {
  open();
  for (const door of ["new", "open", "learn"] as const) {
    hands.click(`door-${door}`);
    expect(useDocument.getState().overlay).toBe(door);
  }
});

it("under an empty program stand the next ones, and nothing while a lesson is open", () => {
  open(<Invitation>examples</Invitation>);
  expect(cards()).toEqual(["tutorial-offer-a", "exercise-offer-b"]);
  expect(page.place.textContent).toContain("examples");
  page.act(() => setOpenLesson("tutorial", { name: "a", done: false }));
  expect(page.place.textContent).toBe("");
  const { path } = useLessons.getState();
  expect(firstOpen(path ?? [], ["a"]).map(({ name }) => name)).toEqual(["b"]);
  expect(firstOpen(path ?? [], ["a", "b"]).map(({ name }) => name)).toEqual(["a", "b"]);
});
