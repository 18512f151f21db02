/** A check is asked for with its properties, answers come as they are found, and one that is chosen opens its run. */
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import type { CheckedProperty, VerifyColumnMessage } from "../../api/generated";
import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import type { Problem } from "../../model/types";
import { useRun } from "../../session/run";
import { furnish } from "../../testing/graph";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted } from "../../testing/hooks";
import { testLine, type TestLine } from "../../testing/socket";
import { CheckPanel } from "./CheckPanel";
import { useCheck } from "./check-session";

const CONFIRMED = { seed: 3, tick: 100, seconds: 2, failures: [] };

function answer(name: string, broken: boolean): CheckedProperty {
  const rest = { left_out: 0, searched: true, scenes: [], guilty: [], places: [], why: null, repeats_from: -1 };
  const events = broken ? [{ step: 1, text: "`a` reaches into the empty storehouse." }] : [];
  const found = { answer: broken ? ("broken" as const) : ("holds" as const), steps: events.length, events };
  return { name, sentence: name, ...rest, ...found, confirmed: broken ? CONFIRMED : null };
}

function column(timing: VerifyColumnMessage["timing"]): VerifyColumnMessage {
  const properties = [answer("empty-storehouse", true), answer("deadlock", false)];
  return {
    type: "column",
    timing,
    failures: 0,
    states: 9,
    depth: 3,
    cut: null,
    is_approximate: false,
    odds: null,
    seconds: 1,
    properties,
  };
}

let page: Mounted;
let hands: Hands;
let line: TestLine;
const start = vi.fn();
const at = () => (document.activeElement as HTMLElement).dataset["testid"];
const properties = () => useStudio.getState().mission.properties ?? [];

beforeEach(async () => {
  furnish();
  await moreWords();
  line = testLine();
  useStudio.getState().openMission(fileOf(missionOf(CARRIER)));
  useRun.setState({ start });
  page = mount(<CheckPanel />);
  hands = handsOn(page);
});
afterEach(() => {
  page.end();
  line.end();
  start.mockClear();
  useRun.setState(useRun.getInitialState());
  useCheck.setState(useCheck.getInitialState());
});

describe("a property", () => {
  it("is written with completion: Enter takes what stands first, and the caret is behind it at once", () => {
    hands.click("property-add-never");
    const field = () => hands.find<HTMLInputElement>("property-first-0");
    page.act(() => field().focus());
    hands.press("property-first-0", "Enter");
    expect([field().value, field().selectionStart]).toEqual(["any ", 4]);
    hands.fill("property-first-0", "any car");
    hands.press("property-first-0", "Enter");
    expect(field().value).toBe("any carrier-1 (");
    hands.fill("property-first-0", "any carrier-1 (Cargo.IsPr");
    hands.press("property-first-0", "Enter");
    expect(field().value).toBe("any carrier-1 (Cargo.IsPressed()");
    hands.fill("property-first-0", "any carrier-1 (Cargo.IsPressed())");
    page.act(() => field().blur());
    page.act(() => hands.find("property-name-0").focus());
    hands.fill("property-name-0", "empty");
    page.act(() => hands.find("property-name-0").blur());
    expect(properties()).toMatchObject([{ name: "empty", form: "never", first: "any carrier-1 (Cargo.IsPressed())" }]);
    hands.click("property-remove-0");
    expect(properties()).toEqual([]);
  });

  it("that is no condition is told with the way out", () => {
    const where = { file: "", line: 1, column: 1, end_line: 1, end_column: 2, program: "", vertices: [], arcs: [] };
    const wrong: Problem = {
      ...where,
      severity: "error",
      code: "mission-property",
      message: "`)` is missing",
      help: "Close it.",
      fix: null,
    };
    page.act(() => useStudio.getState().setReport({ programs: [], problems: [wrong] }));
    expect(hands.find("property-wrong").textContent).toBe("`)` is missing. Close it.".replaceAll("`", ""));
    page.act(() => useStudio.getState().setReport({ programs: [], problems: [] }));
    expect(hands.has("property-wrong")).toBe(false);
  });
});

describe("the check", () => {
  it("asks of which kind failures are only where there are some, and says all of it to the server", () => {
    expect(hands.has("check-kinds")).toBe(false);
    hands.choose("check-failures", "1");
    hands.choose("check-kinds", "mute");
    hands.choose("check-seconds", "1800");
    hands.click("check-begin");
    page.act(() => line.sockets[0]?.open());
    expect(line.sockets[0]?.sent).toMatchObject([{ type: "start", failures: 1, kinds: ["mute"], seconds: 1800 }]);
  });

  it("is stopped, and what was found until then stays", () => {
    hands.click("check-begin");
    page.act(() => line.sockets[0]?.open());
    page.act(() => line.sockets[0]?.say(column("lockstep")));
    hands.click("check-stop");
    expect(line.sockets[0]?.sent.at(-1)).toEqual({ type: "stop" });
    page.act(() => line.sockets[0]?.say({ type: "end", limits: ["Robots do not slip."] }));
    expect([hands.has("check-begin"), hands.has("answer-deadlock-lockstep-0")]).toEqual([true, true]);
    expect(hands.find("check-limits").textContent).toContain("Robots do not slip.");
  });

  it("has answers that arrows walk; Enter opens the run of one, a button closes it and one plays it", () => {
    hands.click("check-begin");
    page.act(() => line.sockets[0]?.open());
    page.act(() => {
      line.sockets[0]?.say(column("lockstep"));
      line.sockets[0]?.say({ type: "end", limits: [] });
    });
    const broken = "answer-empty-storehouse-lockstep-0";
    expect([hands.find(broken).dataset["shape"], hands.find("answer-deadlock-lockstep-0").dataset["shape"]]).toEqual([
      "broken",
      "holds",
    ]);
    page.act(() => hands.find(broken).focus());
    for (const key of ["ArrowDown", "ArrowRight", "ArrowLeft", "ArrowUp"]) hands.press(at() ?? "", key);
    expect(at()).toBe(broken);
    hands.press(broken, "Enter");
    expect(hands.find("check-story").textContent).toContain("reaches into the empty storehouse");
    expect(hands.find("check-seen").dataset["confirmed"]).toBe("true");
    hands.click("check-play");
    expect(start.mock.lastCall?.[1]).toMatchObject({ seed: 3, speed: 0 });
    page.act(() => hands.find("check-run").querySelector("button")?.click());
    expect(hands.has("check-run")).toBe(false);
  });
});
