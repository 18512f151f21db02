/** The field of a comment: it begins with what is kept, and keeps what is written, or takes it back. */
import { act } from "react";
import { afterEach, expect, it, vi } from "vitest";

import { classApi } from "../../../api/class";
import { moreWords } from "../../../i18n/words";
import { handsOn } from "../../../testing/hands";
import { mount, type Mounted } from "../../../testing/hooks";
import { Comment } from "./Comment";
import { useDesk } from "./store";

await moreWords();

let page: Mounted;
afterEach(() => {
  page.end();
  vi.restoreAllMocks();
});

const MARK = { exercise: "x", label: "X", points: 3, of: 5, comment: "Good" };

it.each([
  ["Better =1", "Kept. Ada sees it beside the exercise."],
  ["  ", "The comment is taken back."],
])("%j is kept, and the notice says so", async (words, said) => {
  const asked = vi.spyOn(classApi, "comment").mockResolvedValue(true);
  page = mount(<Comment folder="Ada" name="Ada" exercise="x" mark={MARK} />);
  const hands = handsOn(page);
  expect(hands.find("look-mark").textContent).toBe("Graded: 3 of 5 points");
  const keep = page.place.querySelector<HTMLButtonElement>("[type=submit]");
  expect([hands.find<HTMLInputElement>("comment").value, keep?.disabled]).toEqual(["Good", true]);
  hands.fill("comment", words);
  await act(async () => {
    keep?.click();
    await Promise.resolve();
  });
  expect(asked).toHaveBeenCalledWith("Ada", "x", words);
  expect(useDesk.getState().said?.words).toBe(said);
});

it("no points are explained, since a goal may be met all the same", () => {
  page = mount(<Comment folder="Ada" name="Ada" exercise="x" mark={{ ...MARK, points: 0 }} />);
  expect(handsOn(page).find("look-mark").textContent).toContain("counts only together with another one");
});

it("before grading there is no mark to show", () => {
  page = mount(<Comment folder="Ada" name="Ada" exercise="x" mark={null} />);
  expect(handsOn(page).has("look-mark")).toBe(false);
});
