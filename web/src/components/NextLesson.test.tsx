/** The way on at the end of a lesson. */
import { afterEach, expect, it, vi } from "vitest";

import { moreWords } from "../i18n/words";
import { setOpenLesson } from "../session/lessons";
import { handsOn } from "../testing/hands";
import { mount, type Mounted } from "../testing/hooks";
import { lesson, setPath } from "../testing/lessons";
import { NextLesson } from "./NextLesson";

let page: Mounted;
let end: () => void;
afterEach(() => {
  page.end();
  end();
});

const begin = vi.fn();
async function open() {
  await moreWords();
  end = await setPath(lesson("a", 1), lesson("b", 2, { begin }));
  page = mount(
    <>
      <input data-testid="field" />
      <NextLesson testId="next" takesFocus />
    </>,
  );
  return handsOn(page);
}

it("is not there before the lesson is done; then it has the focus, and leads on", async () => {
  const hands = await open();
  page.act(() => setOpenLesson("exercise", { name: "a", done: false }));
  expect(hands.has("next")).toBe(false);
  page.act(() => setOpenLesson("exercise", { name: "a", done: true }));
  expect(hands.find("next").textContent).toBe("Next: b");
  expect(document.activeElement).toBe(hands.find("next"));
  hands.click("next");
  expect(begin).toHaveBeenCalledOnce();
});

it("takes no focus from who types, and is not there after the last lesson", async () => {
  const hands = await open();
  hands.find("field").focus();
  page.act(() => setOpenLesson("tutorial", { name: "a", done: true }));
  expect(document.activeElement).toBe(hands.find("field"));
  page.act(() => setOpenLesson("tutorial", { name: "b", done: true }));
  expect(hands.has("next")).toBe(false);
});
