/** The teacher's page: how to come in, cards of pupils, one looked on, and what is done with one or with all. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { classApi } from "../../../api/class";
import { api, ApiError } from "../../../api/client";
import { exerciseApi } from "../../../api/exercises";
import type { ClassNewsMessage, Pupil } from "../../../api/generated";
import { partsApi } from "../../../api/parts";
import { moreWords } from "../../../i18n/words";
import { emptyProgram } from "../../../model/commands/changePrograms";
import { type ClassWire, holdClassWire } from "../../../testing/class-wire";
import { type Hands, handsOn } from "../../../testing/hands";
import { mount, type Mounted, settle } from "../../../testing/hooks";
import * as files from "../../../ui/download";
import { useDesk } from "./store";
import { Teacher } from "./Teacher";

await moreWords();

const NEWS: ClassNewsMessage = {
  type: "class",
  name: "Class 5b",
  folder: "Class 5b",
  code: "ABC234",
  address: "http://class",
  qr: [],
  reach: "",
  frozen: false,
  places: 50,
  exercise: "",
  exercise_label: {},
  goals: [],
  asking: [],
  grading: null,
  bytes: 0,
};
const EXERCISE = {
  exercise: "x.exercise.xml",
  exercise_label: { "": "Square" },
  goals: [{ label: { "": "It ends" } }, { label: { "": "A square" } }],
} as Partial<ClassNewsMessage>;
const ZOE: Pupil = {
  folder: "Zoe",
  name: "Zoé",
  word: "DEF567",
  state: "editing",
  seconds: 3,
  running: false,
  file: "03-square.krt",
  version: 1,
  exercise: "x.exercise.xml",
  goals: [
    { reached: true, why: "" },
    { reached: false, why: "It does not turn." },
  ],
  pages: 1,
  frozen: false,
  turn: "pupil",
  mark: null,
};

let wire: ClassWire;
let page: Mounted;
let hands: Hands;

beforeEach(async () => {
  useDesk.setState(useDesk.getInitialState());
  wire = holdClassWire();
  vi.spyOn(partsApi, "catalogue").mockReturnValue(new Promise(() => undefined));
  const program = emptyProgram("p", "r");
  vi.spyOn(classApi, "picture").mockResolvedValue({ version: 1, program });
  page = mount(<Teacher />);
  hands = handsOn(page);
  page.act(() => wire.open());
  await tell({});
});
afterEach(() => {
  page.end();
  useDesk.setState(useDesk.getInitialState());
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

const tell = (news: Partial<ClassNewsMessage>) => settle(() => wire.tell({ ...NEWS, ...news }));
const show = (...changed: Partial<Pupil>[]) =>
  settle(() => wire.tell({ type: "pupils", changed: changed.map((one) => ({ ...ZOE, ...one })), gone: [], kept_s: 0 }));
const press = (testId: string) => settle(() => hands.find(testId).click());
const pressed = (testId: string) => hands.find(testId).getAttribute("aria-pressed");

it("without pupils it says how they come in", () => {
  expect(hands.find("class-empty").textContent).toContain("Nobody is here yet");
  expect(hands.find("class-code").textContent).toBe("ABC 234");
});

it("has a card for each pupil with what was handed in, goals that are reached, and who asks", async () => {
  await tell(EXERCISE);
  await show({}, { folder: "Ben", name: "Ben", state: "asks", frozen: true });
  const card = hands.find("card-Zoe");
  expect([card.dataset["state"], card.querySelectorAll('.class-box[data-met="true"]').length]).toEqual(["editing", 1]);
  expect(card.querySelector(".class-picture svg")).not.toBeNull();
  expect(hands.find("card-Ben").dataset["frozen"]).toBe("true");
  await press("filter-help");
  expect([hands.has("card-Zoe"), hands.find("card-Ben").dataset["state"]]).toEqual([false, "asks"]);
});

it("looks on one: the work, why a goal is missed, words to the pupil, and being there takes the hand down", async () => {
  const write = vi.spyOn(classApi, "write").mockResolvedValue(true);
  const handDown = vi.spyOn(classApi, "handDown").mockResolvedValue(true);
  await tell(EXERCISE);
  await show({ state: "asks" });
  await press("card-Zoe");
  expect(wire.heard("look")).toEqual([{ type: "look", folder: "Zoe" }]);
  expect(hands.find("look").textContent).toContain("03-square.krt");
  expect(hands.find("look").textContent).toContain("It does not turn.");
  hands.fill("write", "Look at the turn");
  await settle(() => hands.find("write").closest("form")?.requestSubmit());
  expect([write.mock.calls, hands.find<HTMLInputElement>("write").value]).toEqual([[["Zoe", "Look at the turn"]], ""]);
  await settle(() =>
    [...hands.find("look").querySelectorAll("button")].find((one) => one.textContent === "I was there")?.click(),
  );
  expect(handDown).toHaveBeenCalledWith("Zoe");
  page.act(() => window.dispatchEvent(new KeyboardEvent("keydown", { key: "Escape" })));
  expect(hands.has("look")).toBe(false);
});

it("shows the arena of the pupil who is looked on, and of nobody else", async () => {
  const world = { name: "w", width_mm: 1000, height_mm: 1000, walls: [], floors: [], lines: [], roads: [], docks: [] };
  const arena = {
    running: true,
    seconds: 2,
    world: { ...world, storehouses: [], starts: [] },
    poses: [[100, 100, 0]],
    way: [],
  };
  await show({});
  await press("card-Zoe");
  await settle(() => wire.tell({ type: "arena", folder: "Ben", arena }));
  expect(hands.has("look-arena")).toBe(false);
  await settle(() => wire.tell({ type: "arena", folder: "Zoe", arena }));
  expect(hands.find("look-arena").querySelectorAll(".picture-robot")).toHaveLength(1);
});

it("asks to edit, leads to a copy once let in, and gives it back", async () => {
  const turn = vi.spyOn(classApi, "turn").mockResolvedValue(true);
  await show({});
  await press("card-Zoe");
  await press("ask-to-edit");
  expect(turn).toHaveBeenLastCalledWith("Zoe", true);
  await show({ turn: "asked" });
  expect(hands.has("edit")).toBe(false);
  await show({ turn: "teacher" });
  expect(hands.find("edit").getAttribute("href")).toContain(`open=${encodeURIComponent("Zoe/03-square.krt")}`);
  await press("give-back");
  expect(turn).toHaveBeenLastCalledWith("Zoe", false);
});

it("freezes one or all, and lets them go on, shown at once", async () => {
  const freeze = vi.spyOn(classApi, "freeze").mockResolvedValue(true);
  await show({}, { folder: "Ben", name: "Ben" });
  await press("card-Zoe");
  await press("look-freeze");
  expect(freeze).toHaveBeenLastCalledWith(true, ["Zoe"]);
  expect(hands.find("card-Zoe").dataset["frozen"]).toBe("true");
  expect(hands.find("look-freeze").textContent).toContain("Let go on");
  await press("look-freeze");
  expect(hands.find("card-Zoe").dataset["frozen"]).toBe("false");
  await press("freeze");
  expect(freeze).toHaveBeenLastCalledWith(true, null);
  expect([pressed("freeze"), hands.find("card-Ben").dataset["frozen"]]).toEqual(["true", "true"]);
  await press("freeze");
  expect([pressed("freeze"), hands.find("card-Ben").dataset["frozen"]]).toEqual(["false", "false"]);
});

it.each([
  ["is copied, which is said", () => Promise.resolve(), "The link to X is copied"],
  ["stands there where it cannot be copied", () => Promise.reject(new Error("no")), "Copy the link to X from here."],
])("a link to an exercise %s", async (_, writeText, said) => {
  const address = "http://class/#exercise=x&code=ABC234";
  const write = vi.fn(writeText);
  vi.stubGlobal("navigator", { ...navigator, clipboard: { writeText: write } });
  vi.spyOn(exerciseApi, "all").mockResolvedValue([
    { name: "example:x.exercise.xml", label: { "": "X" }, icon: "", goals: [{}] } as never,
  ]);
  const link = vi.spyOn(classApi, "link").mockResolvedValue({ address, qr: ["10", "01"] });
  const setExercise = vi.spyOn(classApi, "setExercise");
  await press("change-exercise");
  const copy = document.querySelector<HTMLElement>("[data-link]");
  expect(copy?.getAttribute("aria-label")).toBe("Copy link to X");
  await settle(() => copy?.click());
  expect([link.mock.calls, write.mock.calls]).toEqual([[["example:x.exercise.xml"]], [[address]]]);
  const status = hands.find("exercise-link-said");
  expect([status.getAttribute("role"), status.textContent]).toEqual(["status", expect.stringContaining(said)]);
  const place = hands.find("exercise-link");
  expect(place.textContent).toContain(said);
  expect(place.textContent).toContain(address);
  expect(place.querySelector("svg.class-qr")?.getAttribute("aria-label")).toBe("QR code of the link");
  // The sheet stays, for the next one, and the class has the exercise that it had.
  link.mockRejectedValueOnce(new ApiError("This exercise cannot be used any more.", "Mend it."));
  await settle(() => copy?.click());
  expect(hands.find("exercise-link").textContent).toBe("This exercise cannot be used any more. Mend it.");
  expect(setExercise).not.toHaveBeenCalled();
});

it("hands out a mission and an exercise from its sheets, and saves all work as one file", async () => {
  const mission = { path: "example:blink/blink.krt", name: "blink", example: true, label: {}, help: {}, title: "" };
  vi.spyOn(api, "missions").mockResolvedValue([mission as never]);
  vi.spyOn(exerciseApi, "all").mockResolvedValue([
    { name: "example:x.exercise.xml", label: { "": "X" }, icon: "", goals: [{}] } as never,
  ]);
  const handOut = vi.spyOn(classApi, "handOut").mockResolvedValue({ name: "blink", pupils: 1 });
  const setExercise = vi.spyOn(classApi, "setExercise").mockResolvedValue(true);
  vi.spyOn(classApi, "collect").mockResolvedValue({ bytes: new ArrayBuffer(3), revision: "" });
  const saved = vi.spyOn(files, "download").mockImplementation(() => undefined);
  await show({});
  const choose = (path: string) => settle(() => document.querySelector<HTMLElement>(`[data-path="${path}"]`)?.click());
  await press("send");
  await choose(mission.path);
  expect(handOut).toHaveBeenCalledWith(mission.path, null);
  expect(hands.find("class-said").textContent).toContain("blink");
  await press("change-exercise");
  await choose("example:x.exercise.xml");
  expect(setExercise).toHaveBeenCalledWith("example:x.exercise.xml");
  await press("collect");
  expect(saved.mock.calls[0]?.[0]).toBe("Class 5b.zip");
});
