/** Why an assumption was not seen whole stands at the head of its column, and the verdict says what helps. */
import { act } from "react";
import { createRoot, type Root } from "react-dom/client";
import { afterEach, beforeEach, expect, test } from "vitest";

import type { CheckedProperty, VerifyColumnMessage } from "../../api/generated";
import { moreWords } from "../../i18n/words";
import { growProgram, missionOf } from "../../model/testing/missions";
import { AnswerTable } from "./AnswerTable";
import { plan, TIMINGS } from "./table";
import { Verdict } from "./Verdict";
import { useCheck } from "./check-session";

(globalThis as { IS_REACT_ACT_ENVIRONMENT?: boolean }).IS_REACT_ACT_ENVIRONMENT = true;
const place = document.createElement("div");
let root: Root;
type Cut = VerifyColumnMessage["cut"];

function column(place: number, cut: Cut): VerifyColumnMessage {
  const answer = cut === null ? "holds" : "not finished";
  const rest = { steps: 0, repeats_from: -1, events: [], left_out: 0, confirmed: null, searched: true, why: null };
  return {
    type: "column",
    timing: TIMINGS[place] ?? "free",
    failures: 0,
    states: 10,
    depth: 3,
    cut,
    seconds: 1,
    is_approximate: false,
    odds: null,
    properties: [{ name: "stock", sentence: "no box is lost", answer, ...rest, scenes: [], guilty: [], places: [] }],
  };
}

async function shown(...cuts: Cut[]): Promise<void> {
  await moreWords();
  useCheck.setState({
    asked: { mission: missionOf(growProgram(1, 3, true)), path: "", seed: 1, failures: 0, seconds: 60 },
    plan: plan(0),
    columns: cuts.map((cut, place) => column(place, cut)),
    busy: false,
    progress: null,
    open: null,
  });
  act(() =>
    root.render(
      <>
        <Verdict />
        <AnswerTable />
      </>,
    ),
  );
}

const at = (name: string) => place.querySelector(`[data-testid="${name}"]`)?.textContent;

beforeEach(() => {
  document.body.append(place);
  root = createRoot(place);
});

afterEach(() => {
  act(() => root.unmount());
  useCheck.setState(useCheck.getInitialState());
  document.body.replaceChildren();
});

test("what was seen whole says nothing of limits", async () => {
  await shown(null, null, null);
  expect(at("check-verdict")).toContain("Everything holds");
  expect(TIMINGS.map((timing) => at(`cut-${timing}-0`))).toEqual([undefined, undefined, undefined]);
});

test.each<[Cut, string, string | null]>([
  ["time", "time was up", "Give it more time."],
  ["memory", "came to its limit of memory", "let fewer robots take part"],
  ["states", "came to its limit of states", null],
  ["stopped", "was stopped", null],
  ["size", "a step goes in too many ways", null],
])("of %s it says so at its column, and the verdict what helps", async (cut, words, helps) => {
  await shown(null, null, cut);
  expect(at("cut-prompt-0")).toBeUndefined();
  expect(at("cut-free-0")).toBe(words);
  expect(at("check-verdict")).toContain("Not everything was looked at.");
  for (const other of ["Give it more time.", "let fewer robots take part"])
    expect(at("check-verdict")?.includes(other)).toBe(other === helps);
});

test("what was not come to has no time either", async () => {
  await shown(null);
  expect(at("check-verdict")).toContain("Give it more time.");
});

test("a rough search says what it found, how much it may have missed, and never that all holds", async () => {
  await shown(null);
  const rough = (odds: number, ...answers: CheckedProperty["answer"][]): VerifyColumnMessage => {
    const whole = column(0, null);
    const properties = answers.flatMap((answer) => whole.properties.map((one) => ({ ...one, answer, name: answer })));
    return { ...whole, is_approximate: true, odds, properties };
  };
  act(() => useCheck.setState({ columns: [rough(1 / 512, "nothing found", "not decided")] }));
  expect(at("answer-nothing found-lockstep-0")).toBe("nothing found");
  expect(at("answer-not decided-lockstep-0")).toBe("not decided");
  expect(at("odds-lockstep-0")).toBe("missed: at most 1 in 512");
  expect(at("check-verdict")).toContain("never says that a property holds");
  act(() => useCheck.setState({ columns: [rough(0.9, "nothing found")] }));
  expect(at("odds-lockstep-0")).toBe("its memory was full: it missed most states");
});
