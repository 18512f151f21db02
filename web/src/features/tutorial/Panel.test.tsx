/** What the panel of a tutorial shows of its steps, and where its buttons lead. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import type { Tutorial, TutorialStep } from "../../api/generated";
import { moreWords, speak } from "../../i18n/words";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted } from "../../testing/hooks";
import { TutorialPanel } from "./Panel";
import { begun } from "./progress";
import { enter, heardFits, leave } from "./state";

vi.mock("./step-watch", () => ({ keepWatching: () => () => undefined }));

const step = (name: string): TutorialStep => ({
  label: { "": name },
  help: { "": `How to ${name}.` },
  hint: { "": `Press the key for ${name}.` },
  points: [],
  asks: true,
  events: [],
});
const tutorial: Tutorial = {
  name: "t",
  start: "t.krt",
  label: { "": "Driving" },
  help: {},
  icon: "",
  order: 1000,
  teacher: null,
  problems: [],
  steps: [step("start"), step("turn"), step("stop")],
};

let page: Mounted;
let hands: Hands;
const states = () => [1, 2, 3].map((number) => hands.find(`tutorial-step-${String(number)}`).dataset["state"]);
const shown = () => hands.find("tutorial").dataset["step"];
const says = () => hands.find("tutorial").textContent;
const fits = (...known: boolean[]) => page.act(() => heardFits(known));

beforeEach(async () => {
  await speak("en");
  await moreWords();
  localStorage.clear();
  enter(tutorial, begun("t.krt"));
  page = mount(<TutorialPanel />);
  hands = handsOn(page);
});
afterEach(() => {
  page.end();
  leave();
});

it("shows the step that is to be done, goes on when it is done, and stays for what is not what was asked", () => {
  expect(says()).toContain("How to start.");
  fits(false, false, false);
  expect(shown()).toBe("1");
  fits(true, false, false);
  expect([shown(), states()]).toEqual(["2", ["done", "open", "open"]]);
  expect(says()).toContain("How to turn.");
});

it("says which step is open again when it is undone, and leads there", () => {
  fits(true, true, false);
  fits(false, true, false);
  expect([shown(), states()]).toEqual(["3", ["open", "done", "open"]]);
  expect(hands.find("tutorial-undone").textContent).toBe("Step 1 is open again");
  hands.click("tutorial-undone");
  expect(shown()).toBe("1");
  fits(true, true, false);
  expect(hands.has("tutorial-undone")).toBe(false);
});

it("gives a hint when it is asked for, until the next step", () => {
  expect(hands.has("tutorial-hint")).toBe(false);
  hands.click("tutorial-show");
  expect(hands.find("tutorial-hint").textContent).toContain("Press the key for start.");
  fits(true, false, false);
  expect(hands.has("tutorial-hint")).toBe(false);
});

it("ends with what is left over, which it leads to, or with praise", () => {
  hands.click("tutorial-next");
  fits(false, true, true);
  expect(states()).toEqual(["skipped", "done", "done"]);
  expect(hands.find("tutorial-end").textContent).toContain("1");
  hands.click("tutorial-open-step");
  expect(shown()).toBe("1");
  fits(true, true, true);
  expect(hands.find("tutorial-end").textContent).toContain("That was Driving. Well done!");
});
