/** Programs whose tabs have no room are found in a list, by letters, arrows and Enter. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { moreWords } from "../i18n/words";
import { CARRIER, fileOf, missionOf } from "../model/testing/missions";
import { useStudio } from "../model/studio";
import { furnish } from "../testing/graph";
import { type Hands, handsOn } from "../testing/hands";
import { mount, type Mounted } from "../testing/hooks";
import { ProgramList } from "./ProgramList";

let page: Mounted;
let hands: Hands;
const [leave, close] = [vi.fn(), vi.fn()];
const rows = () => hands.find("program-list").querySelectorAll("li").length;
const active = () => useStudio.getState().activeProgram;

beforeEach(async () => {
  furnish();
  await moreWords();
  const many = Array.from({ length: 40 }, (_, at) => ({ ...CARRIER, name: `many-${String(at + 1)}` }));
  useStudio.getState().openMission(fileOf(missionOf(...many)));
  page = mount(<ProgramList at={{ x: 0, y: 0 }} onLeave={leave} onClose={close} />);
  hands = handsOn({ ...page, place: document.body });
});
afterEach(() => {
  page.end();
  leave.mockClear();
  close.mockClear();
});

it("has all of them, with the focus in its field, and a click opens one", () => {
  expect([rows(), document.activeElement]).toEqual([40, hands.find("program-find")]);
  hands.click("program-option-many-40");
  expect([active(), close.mock.calls.length]).toEqual(["many-40", 1]);
});

it("letters leave those that have them; arrows go round, Enter opens", () => {
  hands.fill("program-find", "many-2");
  expect(rows()).toBe(11);
  hands.press("program-find", "ArrowDown");
  hands.press("program-find", "ArrowUp");
  hands.press("program-find", "ArrowUp");
  hands.press("program-find", "ArrowDown");
  hands.press("program-find", "ArrowDown");
  hands.press("program-find", "Enter");
  expect(active()).toBe("many-20");
});

it("nothing like it is nothing to choose; Escape closes, a press elsewhere leaves", () => {
  hands.fill("program-find", "nothing like it");
  expect(rows()).toBe(0);
  hands.press("program-find", "Enter");
  expect(close).not.toHaveBeenCalled();
  hands.press("program-find", "Escape");
  expect(close).toHaveBeenCalledOnce();
  page.act(() => document.body.dispatchEvent(new Event("pointerdown", { bubbles: true })));
  expect(leave).toHaveBeenCalledOnce();
});
