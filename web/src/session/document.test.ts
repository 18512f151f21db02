import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { begin } from "../app/startup";
import { api } from "../api/client";
import type { Saved } from "../api/generated";
import { emptyProgram } from "../model/commands/changePrograms";
import { useStudio } from "../model/studio";
import type { Mission, MissionFile } from "../model/types";
import { shownName, useDocument } from "./document";
import { beginMission, openFromComputer, openPath } from "./open-requests";
import { useRun } from "./run";
import { hasPlace, save, saveAs } from "./saving";

const MISSION: Mission = {
  version: 1,
  programs: [emptyProgram("p", "r")],
  agents: [],
  goals: [],
  world: "",
};

function file(path: string, revision = "r1"): MissionFile {
  const catalogue = { groups: [], robots: [], problems: [] };
  return { path, name: path, revision, mission: MISSION, problems: [], world: null, catalogue };
}

type Answer = [status: number, body: unknown];

/** A server that answers each "METHOD path" from a list, one after another. */
function serve(answers: Record<string, Answer[]>): string[] {
  const asked: string[] = [];
  vi.stubGlobal("fetch", (address: string, options: { method: string; body?: string }) => {
    const key = `${options.method} ${address}`;
    asked.push(options.method === "PUT" ? `${key} ${(JSON.parse(options.body ?? "") as MissionFile).revision}` : key);
    const [status, body] = answers[key]?.shift() ?? [404, { message: `nobody expected ${key}`, help: "" }];
    return Promise.resolve(new Response(JSON.stringify(body), { status }));
  });
  return asked;
}

function edit(): void {
  const other = { ...MISSION, world: "other.world.xml" };
  useStudio.getState().execute({ label: "Edit", execute: () => other });
}

const banner = () => useDocument.getState().banner;
const choose = (label: string) =>
  banner()
    ?.actions.find((action) => action.label === label)
    ?.run();
const opened = () => useStudio.getState().file.path;

beforeEach(() => {
  useStudio.getState().openMission(file("a.krt"));
  useDocument.setState({ banner: null, overlay: null, ready: true, session: null, fileProblems: [] });
  useRun.getState().reset();
});
afterEach(() => vi.unstubAllGlobals());

describe("the first mission", () => {
  const session = { version: "1", workspace: "w" };

  it("is the one of the command line", async () => {
    serve({
      "GET api/session": [[200, { ...session, path: "b.krt" }]],
      "GET api/mission?path=b.krt": [[200, file("b.krt")]],
    });
    await begin();
    expect([opened(), useDocument.getState().ready]).toEqual(["b.krt", true]);
  });

  it("does not cover what was asked for while it was on its way", async () => {
    serve({
      "GET api/session": [[200, { ...session, path: "b.krt" }]],
      "GET api/mission?path=b.krt": [[200, file("b.krt")]],
      "GET api/mission/new": [[200, file("")]],
    });
    const first = begin();
    beginMission(() => api.newMission(), "n");
    await first;
    await vi.waitFor(() => expect(opened()).toBe(""));
  });

  const entry = { name: "n", title: "t", modified: "", problem: "" };
  const example = { ...entry, path: "example:e", example: true };
  const own = (path: string) => ({ ...entry, path, example: false });

  it("is the folder's only one when none was named", async () => {
    serve({
      "GET api/session": [[200, { ...session, path: null }]],
      "GET api/missions": [[200, [own("x.krt"), example]]],
      "GET api/mission?path=x.krt": [[200, file("x.krt")]],
    });
    await begin();
    expect([opened(), useDocument.getState().overlay]).toEqual(["x.krt", null]);
  });

  it.each([
    ["is chosen where the folder has several", [own("x.krt"), own("y.krt"), example], "open"],
    ["is a new one, begun with pictures, where the folder has none", [example], "new"],
  ])("%s", async (_, missions, overlay) => {
    serve({
      "GET api/session": [[200, { ...session, path: null }]],
      "GET api/missions": [[200, missions]],
      "GET api/mission/new": [[200, file("")]],
    });
    await begin();
    expect([opened(), useDocument.getState().overlay]).toEqual(["", overlay]);
  });

  it("is the one that the address names, for a page that another kitrobot opened", async () => {
    window.history.replaceState(null, "", "/?open=y.krt");
    serve({
      "GET api/session": [[200, { ...session, path: "b.krt" }]],
      "GET api/mission?path=y.krt": [[200, file("y.krt")]],
    });
    await begin();
    expect([opened(), window.location.search]).toEqual(["y.krt", ""]);
  });

  it("is an empty one, with a word, when the file cannot be read", async () => {
    serve({
      "GET api/session": [[200, { ...session, path: "b.krt" }]],
      "GET api/mission?path=b.krt": [[422, { message: "b.krt is damaged.", help: "" }]],
      "GET api/mission/new": [[200, file("")]],
    });
    await begin();
    await vi.waitFor(() => expect(banner()?.message).toBe("b.krt is damaged."));
    expect(opened()).toBe("");
  });

  it("can be tried again when nobody answers", async () => {
    serve({});
    await begin();
    expect(banner()?.actions.map((action) => action.label)).toEqual(["Try again"]);
  });
});

describe("saving", () => {
  it("writes with the revision that was read and keeps the new one", async () => {
    edit();
    const asked = serve({ "PUT api/mission": [[200, { path: "a.krt", revision: "r2" }]] });
    expect(await save()).toBe(true);
    expect(asked).toEqual(["PUT api/mission r1"]);
    expect([useStudio.getState().dirty, useStudio.getState().file.revision]).toEqual([false, "r2"]);
  });

  it("asks for a name where there is none", async () => {
    useStudio.getState().openMission(file("example:transport"));
    expect(await save()).toBe(false);
    expect(useDocument.getState().overlay).toBe("save-as");
  });

  it("lets the person choose when the file was changed meanwhile", async () => {
    edit();
    const asked = serve({
      "PUT api/mission": [
        [409, { message: "changed", help: "", revision: "r9" }],
        [200, { path: "a.krt", revision: "r10" }],
      ],
    });
    expect(await save()).toBe(false);
    expect(banner()?.kind).toBe("question");
    expect(useStudio.getState().dirty).toBe(true);
    choose("Save mine over it");
    await vi.waitFor(() => expect(useStudio.getState().dirty).toBe(false));
    expect(asked).toEqual(["PUT api/mission r1", "PUT api/mission r9"]);
    expect(banner()).toBeNull();
  });

  it("can take the one on disk instead", async () => {
    edit();
    serve({
      "PUT api/mission": [[409, { message: "changed", help: "", revision: "r9" }]],
      "GET api/mission?path=a.krt": [[200, file("a.krt", "r9")]],
    });
    await save();
    choose("Open the one on disk");
    await vi.waitFor(() => expect(useStudio.getState().file.revision).toBe("r9"));
  });

  it("leaves what is changed meanwhile unsaved; the next save waits for this one and goes on from it", async () => {
    edit();
    let answer: (saved: Saved) => void = () => undefined;
    const asked = vi
      .spyOn(api, "saveMission")
      .mockReturnValueOnce(new Promise((resolve) => (answer = resolve)))
      .mockResolvedValueOnce({ path: "a.krt", revision: "r3", locked: true });
    const saving = save();
    await vi.waitFor(() => expect(asked).toHaveBeenCalledOnce());
    useStudio.getState().execute({ label: "More", execute: () => ({ ...MISSION, world: "third.world.xml" }) });
    const next = save();
    await Promise.resolve();
    expect(asked).toHaveBeenCalledOnce();
    answer({ path: "a.krt", revision: "r2", locked: true });
    expect([await saving, useStudio.getState().dirty]).toEqual([false, true]);
    expect([await next, useStudio.getState().dirty]).toEqual([true, false]);
    expect(asked.mock.calls.map(([, revision, mission]) => [revision, mission.world])).toEqual([
      ["r1", "other.world.xml"],
      ["r2", "third.world.xml"],
    ]);
    expect(banner()).toBeNull();
    vi.restoreAllMocks();
  });

  it("says what went wrong and loses nothing", async () => {
    edit();
    serve({ "PUT api/mission": [[500, { message: "The disk is full.", help: "Make room." }]] });
    expect(await save()).toBe(false);
    expect(banner()).toMatchObject({ message: "The disk is full.", help: "Make room." });
    expect(useStudio.getState().dirty).toBe(true);
  });

  it("under a name that is taken says so before it replaces", async () => {
    serve({
      "PUT api/mission": [
        [409, { message: "there", help: "", revision: "r5" }],
        [200, { path: "b.krt", revision: "r6" }],
      ],
    });
    expect(await saveAs("b.krt", "")).toEqual({ taken: "r5" });
    expect(opened()).toBe("a.krt");
    expect(await saveAs("b.krt", "r5")).toBeNull();
    expect(opened()).toBe("b.krt");
  });
});

describe("unsaved changes", () => {
  it("are not thrown away by opening something else", () => {
    edit();
    openPath("b.krt");
    expect(banner()?.actions.map((action) => action.label)).toEqual(["Save", "Go on without saving", "Cancel"]);
    choose("Cancel");
    expect([banner(), opened(), useStudio.getState().dirty]).toEqual([null, "a.krt", true]);
  });

  it("go when the person says so", async () => {
    edit();
    serve({ "GET api/mission/new": [[200, file("")]] });
    beginMission(() => api.newMission(), "n");
    choose("Go on without saving");
    // Here nobody keeps a journal.
    await vi.waitFor(() => expect(banner()?.message).toContain("without saving they would be lost"));
    expect(opened()).toBe("a.krt");
    choose("Discard it");
    await vi.waitFor(() => expect(opened()).toBe(""));
  });

  it("are saved first when the person says so", async () => {
    edit();
    const asked = serve({
      "PUT api/mission": [[200, { path: "a.krt", revision: "r2" }]],
      "GET api/mission?path=b.krt": [[200, file("b.krt")]],
    });
    openPath("b.krt");
    choose("Save");
    await vi.waitFor(() => expect(opened()).toBe("b.krt"));
    expect(asked).toEqual(["PUT api/mission r1", "GET api/mission?path=b.krt"]);
  });
});

it("a damaged file of this computer leaves the open mission alone and says where it is damaged", async () => {
  const problem = { line: 3, message: "Expected a name." };
  serve({ "POST api/mission/read?name=x.krt": [[422, { message: "No.", help: "", problems: [problem] }]] });
  openFromComputer(new File(["<"], "x.krt"));
  await vi.waitFor(() => expect(banner()?.help).toBe("Line 3: Expected a name."));
  expect(opened()).toBe("a.krt");
});

it("examples and new missions have no place to be saved to", () => {
  expect([hasPlace("a.krt"), hasPlace("example:a"), hasPlace("")]).toEqual([true, false, false]);
});

it("a name is shown without its folders", () => {
  expect([shownName("example:a/b.krt"), shownName("")]).toEqual(["b.krt", "untitled.krt"]);
});
