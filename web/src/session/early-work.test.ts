/** Work on a mission that is drawn before the studio is there: it goes on, is kept, and nothing of it is lost. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { api, ApiError } from "../api/client";
import { t } from "../i18n/words";
import { emptyProgram } from "../model/commands/changePrograms";
import { useStudio } from "../model/studio";
import type { Mission, MissionFile } from "../model/types";
import { useDocument } from "./document";
import { earlyWorkOn, hasEarlyWork, keepEarlyWork } from "./early-work";
import { flush, keepJournal, type Store } from "./journal";
import { recover } from "./journal-records";
import { openPath } from "./open-requests";
import { drawAhead, take } from "./opening";

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

let records: string[] = [];
let left: string[] = [];
let full = false;
let end = () => undefined as void;
const kept = vi.fn();

/** The studio is there from now on. */
function beginStudio(): void {
  const write = (text: string[]) => {
    if (full) return Promise.reject(new ApiError("full", "", 507));
    records = text;
    return Promise.resolve({ bytes: 1 });
  };
  const store: Store = {
    api: {
      claim: (_, path) => Promise.resolve({ journal: "j", path, name: path, records: left, damaged: false }),
      replace: (_tab, _path, _name, all) => write(all),
      append: (_tab, _first, more) => write([...records, ...more]),
    },
    watch: (watcher) => {
      void watcher.onHello("tab");
      return () => undefined;
    },
  };
  end = keepJournal(
    () => undefined,
    () => undefined,
    store,
  );
}

function edit(world: string): void {
  useStudio.getState().execute({ label: world, execute: (mission) => ({ ...mission, world }) });
}

const world = () => useStudio.getState().mission.world;
const written = () => recover(records)?.history;

function forgetPage(): void {
  useDocument.setState({ ready: false, ahead: false, banner: null, overlay: null });
}

beforeEach(() => {
  forgetPage();
  localStorage.clear();
  sessionStorage.clear();
  [records, left, full] = [[], [], false];
  kept.mockClear();
});

afterEach(() => {
  end();
  end = () => undefined;
  forgetPage();
  localStorage.clear();
});

it("what is done before the studio is there stays, with its undo, its selection and the sheet that is open", async () => {
  drawAhead(FILE);
  keepEarlyWork(kept);
  edit("one");
  edit("two");
  useStudio.getState().select(["start"]);
  useDocument.setState({ overlay: "save-as" });
  beginStudio();
  await take(FILE);
  expect(world()).toBe("two");
  expect(useStudio.getState().selection).toEqual(["start"]);
  expect(useDocument.getState()).toMatchObject({ ready: true, ahead: false, overlay: "save-as", banner: null });
  await vi.waitFor(() => expect(kept).toHaveBeenCalledOnce());
  expect(written()?.mission.world).toBe("two");
  expect(written()?.past).toHaveLength(2);
  expect(hasEarlyWork()).toBe(false);
  useStudio.getState().undo();
  expect(world()).toBe("one");
  await flush();
  expect(written()?.mission.world).toBe("one");
});

it("a mission to which nothing was done stays as it is, and the journal is empty", async () => {
  drawAhead(FILE);
  keepEarlyWork(kept);
  const { mission } = useStudio.getState();
  beginStudio();
  await take(FILE);
  await flush();
  expect(useStudio.getState().mission).toBe(mission);
  expect([useDocument.getState().ready, hasEarlyWork(), records]).toEqual([true, false, []]);
  expect(kept).not.toHaveBeenCalled();
});

it("a page that is loaded again before the studio was there has the work", () => {
  drawAhead(FILE);
  keepEarlyWork(kept);
  edit("one");
  edit("two");
  useStudio.getState().undo();
  forgetPage();
  drawAhead(FILE, earlyWorkOn(FILE)?.history);
  expect(world()).toBe("one");
  useStudio.getState().redo();
  expect(world()).toBe("two");
  useStudio.getState().undo();
  useStudio.getState().undo();
  expect(world()).toBe("");
});

it("a studio that is there before the mission is drawn opens it with the work, and says so", async () => {
  drawAhead(FILE);
  keepEarlyWork(kept);
  edit("one");
  forgetPage();
  beginStudio();
  await take(FILE);
  expect(world()).toBe("one");
  expect(useDocument.getState().banner?.message).toContain("a.krt");
  await flush();
  expect(written()?.mission.world).toBe("one");
});

it("work that is taken back as a whole is none", () => {
  drawAhead(FILE);
  keepEarlyWork(kept);
  edit("one");
  expect(hasEarlyWork()).toBe(true);
  const { history } = useStudio.getState();
  useStudio.getState().undo();
  // What can be done again is still something.
  expect(hasEarlyWork()).toBe(true);
  expect(earlyWorkOn(FILE)?.history.future).toHaveLength(history.past.length);
});

it("what the journal has of the mission is opened where nothing was done to it now", async () => {
  drawAhead(FILE);
  edit("left");
  beginStudio();
  await take(FILE);
  await flush();
  left = records;
  end();
  localStorage.clear();
  forgetPage();
  drawAhead(FILE);
  beginStudio();
  await take(FILE);
  expect(world()).toBe("left");
});

it("what came back can be discarded: then the file is open as it is on disk, and the journal is empty", async () => {
  beginStudio();
  await take(FILE);
  edit("left");
  await flush();
  left = records;
  end();
  forgetPage();
  beginStudio();
  await take(FILE);
  expect([world(), useDocument.getState().banner?.message]).toEqual(["left", "Your unsaved work on a.krt is back."]);
  left = [];
  vi.spyOn(api, "mission").mockResolvedValue(FILE);
  useDocument
    .getState()
    .banner?.actions.find(({ label }) => label === "Discard it")
    ?.run();
  await vi.waitFor(() => expect(world()).toBe(""));
  await flush();
  expect([records, useStudio.getState().dirty, useDocument.getState().banner]).toEqual([[], false, null]);
  vi.restoreAllMocks();
});

it("work that is left for another mission is in the journal, and that is said", async () => {
  beginStudio();
  await take(FILE);
  edit("left");
  vi.spyOn(api, "mission").mockResolvedValue({ ...FILE, path: "b.krt", name: "b.krt" });
  openPath("b.krt");
  const asks = useDocument.getState().banner;
  expect([asks?.takesFocus, asks?.help]).toEqual([true, t("journal.leave-help")]);
  asks?.actions.find(({ label }) => label === "Go on without saving")?.run();
  await vi.waitFor(() => expect(useStudio.getState().file.path).toBe("b.krt"));
  await vi.waitFor(() => expect(useDocument.getState().banner?.message).toBe("Unsaved work on a.krt is kept."));
  vi.restoreAllMocks();
});

it("work that no journal takes stays with the browser", async () => {
  full = true;
  drawAhead(FILE);
  keepEarlyWork(kept);
  edit("one");
  beginStudio();
  await take(FILE);
  await flush();
  expect([kept.mock.calls.length, hasEarlyWork(), world()]).toEqual([0, true, "one"]);
});

it.each([
  ["another revision of it", { revision: "r2" }],
  ["another mission", { path: "example:b.krt" }],
])("work on %s is none on this one", (_, other) => {
  drawAhead(FILE);
  keepEarlyWork(kept);
  edit("one");
  expect(earlyWorkOn({ ...FILE, ...other })).toBeNull();
});

it.each([
  "",
  "{",
  "null",
  "[]",
  '{"path":"example:a.krt","revision":"r1"}',
  '{"path":"example:a.krt","revision":"r1","records":["x"]}',
])("%j in its place is no work", (text) => {
  localStorage.setItem("kitrobot.early", text);
  expect(earlyWorkOn(FILE)).toBeNull();
});

it("a browser that keeps nothing lets the mission be edited", () => {
  vi.spyOn(Storage.prototype, "setItem").mockImplementation(() => {
    throw new DOMException("full", "QuotaExceededError");
  });
  drawAhead(FILE);
  keepEarlyWork(kept);
  edit("one");
  vi.restoreAllMocks();
  expect([world(), hasEarlyWork()]).toEqual(["one", false]);
});
