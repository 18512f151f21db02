import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import type { Followed } from "../api/client";
import { ApiError } from "../api/client";
import { changeBetween } from "../components/text/TextEditor";
import { showMistakes } from "../features/code/mistakes";
import { replaceProgram } from "../model/command";
import { useStudio } from "../model/studio";
import { CARRIER, missionOf } from "../model/testing/missions";
import type { Problem, Program } from "../model/types";
import { isChecked } from "./report";
import { connectTyping, isUnfinished, setFocused, typeText, useTyping, whenFollowed } from "./typing";

const NAME = CARRIER.name;
const BEFORE = { text: "printed", spans: [] };
const mistake: Problem = {
  ...{ file: `${NAME}.lll`, line: 1, column: 1, end_line: 1, end_column: 2, help: "", arcs: [] },
  ...{ severity: "error", code: "syntax", message: "no", program: NAME, vertices: [] },
};

function withNote(program: Program, text: string): Program {
  const vertices = program.vertices.map((one, at) => (at === 0 ? { ...one, notes: [{ text, at: "" }] } : one));
  return { ...program, vertices };
}

let answers: Map<string, Followed | Error>;
const asked = vi.fn((text: string): Promise<Followed> => {
  const answer = answers.get(text);
  if (answer === undefined || answer instanceof Error) return Promise.reject(answer ?? new Error(text));
  return Promise.resolve(answer);
});
let ends: (() => void)[];

const now = () => useStudio.getState().mission.programs.find((one) => one.name === NAME);
const draft = () => useTyping.getState().drafts[NAME];

async function type(text: string, answer: Followed | Error): Promise<void> {
  answers.set(text, answer);
  typeText(NAME, text, BEFORE);
  await vi.advanceTimersByTimeAsync(200);
}

const right = (program: Program): Followed => ({ program, spans: [], problems: [], report: null });
const wrong: Followed = { program: null, spans: [], problems: [mistake], report: null };

beforeEach(() => {
  vi.useFakeTimers();
  asked.mockClear();
  answers = new Map();
  useStudio.getState().openMission({
    ...{ path: "a.krt", name: "a.krt", revision: "", problems: [], world: null },
    mission: missionOf(CARRIER),
    catalogue: { groups: [], robots: [], problems: [] },
  });
  useStudio.getState().setReport({ programs: [], problems: [] });
  ends = [connectTyping((_mission, _path, _program, text) => asked(text)), showMistakes()];
  setFocused(NAME, true);
});

afterEach(() => {
  for (const end of ends) end();
  setFocused(NAME, false);
  vi.useRealTimers();
});

describe("typing", () => {
  it("becomes one command a burst, which undo takes back with the text", async () => {
    await type("one", right(withNote(CARRIER, "1")));
    await type("two", right(withNote(CARRIER, "2")));
    expect(now()?.vertices[0]?.notes).toEqual([{ text: "2", at: "" }]);
    expect(useStudio.getState().undoLabel).toBe("Edit text");
    useStudio.getState().undo();
    expect(now()).toBe(CARRIER);
    expect(useStudio.getState().canUndo).toBe(false);
    expect(draft()?.text).toBe("printed");
    useStudio.getState().redo();
    expect(draft()?.text).toBe("two");
  });

  it("is waited for by who wants to run what was typed", async () => {
    const seen = vi.fn<(notes?: unknown) => void>();
    answers.set("one", right(withNote(CARRIER, "1")));
    typeText(NAME, "one", BEFORE);
    whenFollowed(() => seen(now()?.vertices[0]?.notes));
    expect(seen).not.toHaveBeenCalled();
    await vi.advanceTimersByTimeAsync(200);
    expect(seen.mock.calls).toEqual([[[{ text: "1", at: "" }]]]);
    whenFollowed(seen);
    expect(seen).toHaveBeenCalledTimes(2);
  });

  it("is one burst however late the server answers, and another one after a pause", async () => {
    await type("one", right(withNote(CARRIER, "1")));
    asked.mockImplementationOnce(
      () => new Promise((resolve) => setTimeout(() => resolve(right(withNote(CARRIER, "2"))), 60_000)),
    );
    typeText(NAME, "two", BEFORE);
    await vi.advanceTimersByTimeAsync(60_000);
    await type("three", right(withNote(CARRIER, "3")));
    expect(now()?.vertices[0]?.notes).toEqual([{ text: "3", at: "" }]);
    useStudio.getState().undo();
    expect(now()?.vertices[0]?.notes).toEqual([{ text: "2", at: "" }]);
    useStudio.getState().undo();
    expect(now()).toBe(CARRIER);
  });

  it("changes nothing when only the layout differs, and keeps the text as typed", async () => {
    await type("  one", right(withNote(CARRIER, "")));
    useStudio.getState().undo();
    await type("   one", right(CARRIER));
    expect(now()).toBe(CARRIER);
    expect(draft()?.text).toBe("   one");
  });

  it("with a mistake leaves the graph alone and says so among the problems", async () => {
    await type("one(", wrong);
    expect(now()).toBe(CARRIER);
    expect([draft()?.right, isUnfinished(NAME)]).toEqual([false, true]);
    expect(useStudio.getState().report?.problems).toEqual([mistake]);
    useStudio.getState().setReport({ programs: [], problems: [] });
    expect(useStudio.getState().report?.problems).toEqual([mistake]);
    await type("one", right(CARRIER));
    expect(useStudio.getState().report?.problems).toEqual([]);
    expect(isUnfinished(NAME)).toBe(false);
  });

  it("that the server cannot look at says why", async () => {
    await type("long", new ApiError("too long.", "Shorten it."));
    expect([draft()?.failure, draft()?.right]).toEqual(["too long. Shorten it.", false]);
  });

  it("ends when the editor is left, and stays while it has mistakes", async () => {
    await type("one(", wrong);
    setFocused(NAME, false);
    expect(draft()?.text).toBe("one(");
    setFocused(NAME, true);
    await type("one", right(CARRIER));
    setFocused(NAME, false);
    expect(draft()).toBeUndefined();
  });

  it("ends when the answer comes after the editor was left", async () => {
    answers.set("one", right(CARRIER));
    typeText(NAME, "one", BEFORE);
    setFocused(NAME, false);
    expect(draft()?.text).toBe("one");
    await vi.advanceTimersByTimeAsync(200);
    expect(draft()).toBeUndefined();
  });

  it("ends when the graph is edited meanwhile, whatever the answer", async () => {
    answers.set("one", right(withNote(CARRIER, "1")));
    typeText(NAME, "one", BEFORE);
    const other = withNote(CARRIER, "other");
    useStudio.getState().execute(replaceProgram("Other", CARRIER, other));
    await vi.advanceTimersByTimeAsync(200);
    expect(draft()).toBeUndefined();
    expect(now()).toBe(other);
  });

  it("asks at once, before anything is drawn", () => {
    answers.set("one", right(CARRIER));
    typeText(NAME, "one", BEFORE);
    expect(asked).toHaveBeenCalledTimes(1);
  });

  it("of an overtaken text is never taken, and the newest is asked for next", async () => {
    let answer: (followed: Followed) => void = () => undefined;
    asked.mockImplementationOnce(() => new Promise((resolve) => (answer = resolve)));
    typeText(NAME, "one", BEFORE);
    await vi.advanceTimersByTimeAsync(10);
    answers.set("three", wrong);
    typeText(NAME, "two", BEFORE);
    typeText(NAME, "three", BEFORE);
    await vi.advanceTimersByTimeAsync(10);
    expect(asked.mock.calls.map(([text]) => text)).toEqual(["one"]);
    answer(right(withNote(CARRIER, "1")));
    await vi.advanceTimersByTimeAsync(10);
    expect(asked.mock.calls.map(([text]) => text)).toEqual(["one", "three"]);
    expect(now()).toBe(CARRIER);
    expect(draft()?.right).toBe(false);
  });

  it("brings the report with it, which is about the mission with the new program", async () => {
    const report = { programs: [], problems: [mistake] };
    const unasked: unknown[] = [];
    ends.push(useStudio.subscribe(({ mission }) => isChecked(mission) || unasked.push(mission)));
    await type("report", { ...right(withNote(CARRIER, "R")), report });
    expect(useStudio.getState().report).toBe(report);
    expect(isChecked(useStudio.getState().mission)).toBe(true);
    expect(unasked).toEqual([]);
    useStudio.getState().undo();
    expect(isChecked(useStudio.getState().mission)).toBe(false);
  });
});

describe("the change between two texts", () => {
  it.each([
    ["", ""],
    ["abc", "abc"],
    ["aaa", "aaaa"],
    ["abcd", "ad"],
    ["", "x"],
    ["x", ""],
    ["one two", "one three two"],
  ])("%j to %j makes the one the other", (before, after) => {
    const { from, to, insert } = changeBetween(before, after);
    expect(before.slice(0, from) + insert + before.slice(to)).toBe(after);
  });
});
