/** A pupil's page in a class: what the teacher wants, whether the work is kept, the hand, and who edits. */
import { act } from "react";
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { classApi } from "../../api/class";
import { api } from "../../api/client";
import { exerciseApi } from "../../api/exercises";
import type { PupilNewsMessage } from "../../api/generated";
import { moreWords } from "../../i18n/words";
import { emptyProgram } from "../../model/commands/changePrograms";
import { useStudio } from "../../model/studio";
import type { Mission, MissionFile } from "../../model/types";
import { useDocument } from "../../session/document";
import { remember, setComments, useOpenExercise } from "../../session/open-exercise";
import { type ClassWire, holdClassWire } from "../../testing/class-wire";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted } from "../../testing/hooks";
import { PupilBar, PupilKept } from "./Pupil";
import { useClassroom } from "./classroom";

await moreWords();

const MISSION: Mission = { version: 1, programs: [emptyProgram("p", "r")], agents: [], goals: [], world: "" };
const FILE: MissionFile = {
  path: "example:a.krt",
  name: "a.krt",
  revision: "r1",
  mission: MISSION,
  problems: [],
  world: null,
  catalogue: { groups: [], robots: [], problems: [] },
};
const NEWS: PupilNewsMessage = {
  type: "pupil",
  class_name: "5b",
  name: "Ada",
  word: "ABCDEF",
  frozen: false,
  exercise: "",
  handed: 0,
  handed_name: "",
  note: 0,
  note_text: "",
  looked: false,
  hand: false,
  turn: "pupil",
  comments: {},
};
const GOAL = { label: {}, kind: "run" as const };
const SQUARE = { name: "x.exercise.xml", start: FILE.path, label: { "": "Square" }, goals: [GOAL] };
/** What is in the studio beside what the class draws, as far as holding it is concerned. */
const STUDIO = '<button class="team-stop">STOP</button><div class="middle"><button id="tool">Tool</button></div>';

let wire: ClassWire;
let page: Mounted;
let hands: Hands;
let studio: HTMLElement;

beforeEach(async () => {
  localStorage.clear();
  useClassroom.setState(useClassroom.getInitialState());
  useStudio.getState().openMission(FILE);
  useDocument.setState({ ready: true, banner: null });
  wire = holdClassWire();
  vi.spyOn(classApi, "works").mockResolvedValue([]);
  vi.spyOn(classApi, "exercise").mockResolvedValue(new ArrayBuffer(0));
  studio = document.createElement("div");
  studio.innerHTML = STUDIO;
  document.body.append(studio);
  page = mount(
    <>
      <PupilBar />
      <PupilKept />
    </>,
  );
  hands = handsOn(page);
  await act(() => Promise.resolve(wire.open()));
  await hear({});
});

afterEach(() => {
  page.end();
  studio.remove();
  useClassroom.setState(useClassroom.getInitialState());
  setComments({});
  remember(null);
  localStorage.clear();
  vi.useRealTimers();
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

/** The class tells the page, and the page has done what it does then. */
async function hear(news: Partial<PupilNewsMessage>): Promise<void> {
  await act(async () => {
    wire.tell({ ...NEWS, ...news });
    await vi.waitFor(() => expect(useClassroom.getState().news).not.toBeNull());
    for (let turn = 0; turn < 20; turn++) await Promise.resolve();
  });
}

function edit(world = "other.world.xml"): void {
  page.act(() => useStudio.getState().execute({ label: "Edit", execute: (mission) => ({ ...mission, world }) }));
}

const kept = () => hands.find("class-kept").dataset["kept"];
const frozen = () => document.querySelector('[data-testid="class-frozen"]');
const middle = () => studio.querySelector<HTMLElement>(".middle");

/** Whether a key reaches the page behind what is held. */
function reaches(from: Element | null, key: string, held: KeyboardEventInit = {}): boolean {
  return from?.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true, ...held })) ?? false;
}

it("is frozen: nothing can be pressed or typed but STOP, until the teacher lets it go on", async () => {
  await hear({ frozen: true });
  expect(frozen()?.textContent).toContain("Look up");
  expect(middle()?.inert).toBe(true);
  const [tool, stop] = [studio.querySelector("#tool"), studio.querySelector(".team-stop")];
  expect([reaches(tool, "z", { ctrlKey: true }), reaches(tool, "F5")]).toEqual([false, false]);
  expect([reaches(tool, "F5", { shiftKey: true }), reaches(stop, "Enter")]).toEqual([true, true]);
  await hear({});
  expect([frozen(), middle()?.inert, reaches(tool, "F5")]).toEqual([null, false, true]);
});

it("hands in what is done, and keeps it here while the class does not answer", async () => {
  vi.useFakeTimers();
  const handIn = vi.spyOn(classApi, "handIn").mockResolvedValue({ name: "a", revision: "r2" });
  edit();
  expect(kept()).toBe("waits");
  await act(() => vi.advanceTimersByTimeAsync(2000));
  expect([kept(), handIn.mock.calls[0]?.slice(0, 2)]).toEqual(["yes", ["a.krt", ""]]);
  page.act(() => wire.lose());
  expect(kept()).toBe("here");
  handIn.mockRejectedValueOnce(new Error("nobody answers"));
  edit("third.world.xml");
  await act(() => vi.advanceTimersByTimeAsync(2000));
  expect(kept()).toBe("here");
  await act(() => vi.advanceTimersByTimeAsync(5000));
  page.act(() => wire.open());
  await act(() => vi.advanceTimersByTimeAsync(100));
  expect(kept()).toBe("yes");
  expect(handIn.mock.lastCall?.[1]).toBe("r2");
  expect(handIn.mock.lastCall?.[2].world).toBe("third.world.xml");
});

it("hands in at once what is asked for, for its exercise, and says so", async () => {
  vi.useFakeTimers();
  const handIn = vi.spyOn(classApi, "handIn").mockRejectedValueOnce(new Error("nobody answers"));
  handIn.mockResolvedValue({ name: "a.krt", revision: "r2" });
  remember({ name: "x.exercise.xml", path: FILE.path });
  page.act(() => useOpenExercise.getState().handIn?.());
  await act(() => vi.advanceTimersByTimeAsync(100));
  expect(handIn.mock.calls).toEqual([["a.krt", "", MISSION, "x.exercise.xml"]]);
  expect(useDocument.getState().banner?.message).toBe("Your work is kept here");
  await act(() => vi.advanceTimersByTimeAsync(5000));
  expect(useDocument.getState().banner?.message).toBe("Handed in to 5b: a.krt.");
  // What goes by itself is not said; in another mission it is for no exercise.
  page.act(() => useDocument.setState({ banner: null }));
  page.act(() => useStudio.getState().openMission({ ...FILE, path: "", name: "b.krt" }));
  edit();
  await act(() => vi.advanceTimersByTimeAsync(5000));
  expect(handIn.mock.lastCall?.[3]).toBe("");
  expect(useDocument.getState().banner).toBeNull();
  page.end();
  expect(useOpenExercise.getState().handIn).toBeNull();
});

it("opens what a link names in place of what comes first", async () => {
  page.end();
  localStorage.clear();
  useClassroom.setState(useClassroom.getInitialState());
  window.history.replaceState(null, "", "#exercise=x.exercise.xml&class=5b&code=ABCDEF");
  vi.spyOn(exerciseApi, "all").mockResolvedValue([SQUARE as never]);
  vi.mocked(classApi.works).mockResolvedValue([
    { name: "new.krt", bytes: 1, modified: "", exercise: "" },
    { name: "square.krt", bytes: 1, modified: "", exercise: SQUARE.name },
  ]);
  const work = vi.spyOn(classApi, "work").mockResolvedValue({ bytes: new ArrayBuffer(0), revision: "r7" });
  vi.spyOn(api, "readMission").mockResolvedValue({ ...FILE, path: "", name: "square.krt" });
  page = mount(<PupilBar />);
  await act(() => Promise.resolve(wire.open()));
  await hear({});
  await act(() => vi.waitFor(() => expect(useStudio.getState().file.name).toBe("square.krt")));
  expect(work.mock.calls).toEqual([["square.krt"]]);
  expect(useOpenExercise.getState().open).toEqual({ name: SQUARE.name, path: "square.krt" });
  expect(window.location.hash).toBe("");
});

it("puts the hand up and down, and the class has the last word", async () => {
  hands.click("class-hand");
  expect(wire.heard("hand")).toEqual([{ type: "hand", up: true }]);
  expect(hands.find("class-hand").getAttribute("aria-pressed")).toBe("true");
  await hear({ hand: true });
  await hear({ hand: false });
  expect(hands.find("class-hand").getAttribute("aria-pressed")).toBe("false");
});

it("shows a few words of the teacher's until they are read, and who looks on", async () => {
  await hear({ note: 1, note_text: "Look at the turn", looked: true });
  expect(hands.find("class-note").textContent).toContain("Look at the turn");
  expect(hands.has("class-looked")).toBe(true);
  page.act(() => hands.find("class-note").querySelector("button")?.click());
  await hear({ note: 1, note_text: "Look at the turn" });
  expect([hands.has("class-note"), hands.has("class-looked")]).toEqual([false, false]);
});

it("opens what is handed out where nothing is unsaved, else offers it", async () => {
  vi.spyOn(classApi, "handed").mockResolvedValue({ bytes: new ArrayBuffer(0), revision: "" });
  const read = vi.spyOn(api, "readMission").mockResolvedValue({ ...FILE, path: "", name: "blink.krt" });
  edit();
  await hear({ handed: 1, handed_name: "blink" });
  expect(hands.find("class-handed").textContent).toContain("blink");
  expect(read).not.toHaveBeenCalled();
  page.act(() => useStudio.getState().undo());
  await hear({ handed: 2, handed_name: "blink" });
  await vi.waitFor(() => expect(useStudio.getState().file.name).toContain("blink"));
});

it("opens the exercise of the class, and shows a comment on another one", async () => {
  const one = SQUARE;
  vi.spyOn(exerciseApi, "all").mockResolvedValue([one as never]);
  await hear({ exercise: one.name });
  expect(useOpenExercise.getState().open).toEqual({ name: one.name, path: one.start });
  await hear({ exercise: one.name, comments: { [one.name]: "A fine square" } });
  expect(useOpenExercise.getState().comments).toEqual({ [one.name]: "A fine square" });
  // The panel of the exercise that is open shows it.
  expect(hands.has("class-comment")).toBe(false);
  await hear({ exercise: one.name, comments: { [one.name]: "A fine square", "y.exercise.xml": "Good" } });
  expect(hands.find("class-comment").textContent).toContain("Good");
});

it("lets the teacher edit once all is handed in, and takes what was saved back as one step", async () => {
  vi.spyOn(classApi, "handIn").mockResolvedValue({ name: "a", revision: "r2" });
  edit();
  await hear({ turn: "asked" });
  hands.click("class-let-edit");
  await act(() => vi.waitFor(() => expect(wire.heard("turn")).toEqual([{ type: "turn", yes: true }])));
  await hear({ turn: "teacher" });
  expect(frozen()?.textContent).toContain("Your teacher edits your mission");
  expect(middle()?.inert).toBe(true);
  const changed = { ...MISSION, world: "teacher.world.xml" };
  vi.spyOn(classApi, "work").mockResolvedValue({ bytes: new ArrayBuffer(0), revision: "r3" });
  vi.spyOn(api, "readMission").mockResolvedValue({ ...FILE, mission: changed });
  await hear({ turn: "pupil" });
  await vi.waitFor(() => expect(useStudio.getState().mission.world).toBe("teacher.world.xml"));
  expect([frozen(), middle()?.inert]).toEqual([null, false]);
  page.act(() => useStudio.getState().undo());
  expect(useStudio.getState().mission.world).toBe("other.world.xml");
});

it("takes the mission back from the teacher", async () => {
  await hear({ turn: "teacher" });
  page.act(() => document.querySelector<HTMLElement>('[data-testid="class-take-back"]')?.click());
  expect(wire.heard("turn")).toEqual([{ type: "turn", yes: false }]);
});
