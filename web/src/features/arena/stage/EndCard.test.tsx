/** The card of the result: what can be done next. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import type { Painter } from "../../../components/scene/painter";
import { moreWords } from "../../../i18n/words";
import { setOpenLesson } from "../../../session/lessons";
import * as penMarks from "../../../session/pen-marks";
import { useRun } from "../../../session/run";
import { type Hands, handsOn } from "../../../testing/hands";
import { mount, type Mounted } from "../../../testing/hooks";
import { lesson, setPath } from "../../../testing/lessons";
import { EndCard, setFacts } from "./EndCard";
import { StageLayers } from "./layers";

const begin = vi.fn();
const begun = useRun.getState();
let page: Mounted;
let hands: Hands;
let end: () => void;

beforeEach(async () => {
  vi.stubGlobal(
    "ResizeObserver",
    class {
      observe = vi.fn();
      disconnect = vi.fn();
    },
  );
  await moreWords();
  end = await setPath(lesson("a", 1), lesson("b", 2, { begin }));
  useRun.setState({ ...begun, status: "done", sentence: "Done.", name: "run-1" });
  const facts = { done: true, sentence: "Done.", atOnce: false, goals: { reached: 0, count: 0 }, lines: [] };
  setFacts({ ...facts, driven: [{ name: "robot-1", mm: 300 }], tickMs: 20, deeds: [], acted: true }, "run-1");
  page = mount(<EndCard painter={{ setCovered: () => undefined } as unknown as Painter} />);
  hands = handsOn(page);
});
afterEach(() => {
  page.end();
  end();
  useRun.setState(begun);
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

it("leads on along the path once the lesson is done", () => {
  page.act(() => setOpenLesson("exercise", { name: "a", done: false }));
  expect(hands.has("ending-next")).toBe(false);
  page.act(() => setOpenLesson("exercise", { name: "a", done: true }));
  expect(hands.find("ending-next").textContent).toBe("Next: b");
  hands.click("ending-next");
  expect(begin).toHaveBeenCalledOnce();
});

it("offers a drawing of one's own to be saved, and none in a lesson or where nothing was drawn", () => {
  expect(hands.has("ending-save-drawing")).toBe(false);
  vi.spyOn(penMarks, "drawnByPens").mockReturnValue({ marks: [{}], pens: [] } as never);
  page.act(() => useRun.setState({ tick: 1 }));
  expect(hands.find("ending-save-drawing").textContent).toBe("Save the drawing");
  page.act(() => setOpenLesson("tutorial", { name: "a", done: false }));
  expect(hands.has("ending-save-drawing")).toBe(false);
});

it("paper falls when a lesson is done, once", () => {
  const again = vi.fn();
  const stop = new StageLayers(again).celebrateGoals();
  page.act(() => setOpenLesson("tutorial", { name: "a", done: false }));
  expect(again).not.toHaveBeenCalled();
  page.act(() => setOpenLesson("tutorial", { name: "a", done: true }));
  expect(again).toHaveBeenCalledOnce();
  stop();
});
