import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { ApiError } from "../api/client";
import type { ClaimedJournal } from "../api/generated";
import type { Watcher } from "../api/watch";
import { emptyProgram } from "../model/commands/changePrograms";
import { isUnsaved } from "../model/history";
import { useStudio } from "../model/studio";
import type { Mission, MissionFile } from "../model/types";
import { claim, flush, isKept, keepJournal, openWith, type Store } from "./journal";
import { recover, recordsOf, shortened } from "./journal-records";

const MISSION: Mission = { version: 1, programs: [emptyProgram("p", "r")], agents: [], goals: [], world: "" };

function file(path: string, mission = MISSION): MissionFile {
  const catalogue = { groups: [], robots: [], problems: [] };
  return { path, name: path, revision: "r1", mission, problems: [], world: null, catalogue };
}

let number = 0;

/** An edit in the first program, or of the world. */
function edit(joins?: string): void {
  const before = useStudio.getState().mission;
  number++;
  const vertex = { id: `v${String(number)}`, element: "Wait", settings: { duration: String(number) }, notes: [] };
  const programs = before.programs.map((one) => ({ ...one, vertices: [...one.vertices, vertex] }));
  const after = number % 3 === 0 ? { ...before, world: `w${String(number)}` } : { ...before, programs };
  const command = { label: `Edit ${String(number)}`, execute: () => after };
  useStudio.getState().execute(joins === undefined ? command : { ...command, joins });
}

/** A server that keeps one journal in memory, and can fail. */
class Kept {
  records: string[] = [];
  unsaved = false;
  wholes = 0;
  refused = 0;
  trouble: ApiError | null = null;
  watcher: Watcher | null = null;
  readonly store: Store = {
    api: {
      claim: (_tab, path, journal): Promise<ClaimedJournal> =>
        Promise.resolve({ journal: journal || "j", path, name: path, records: this.records, damaged: false }),
      replace: (_tab, _path, _name, records, unsaved) => this.write(0, records, unsaved),
      append: (_tab, first, records, unsaved) => this.write(first, records, unsaved),
    },
    watch: (watcher) => {
      this.watcher = watcher;
      void watcher.onHello("tab");
      return () => undefined;
    },
  };

  private write(first: number, records: string[], unsaved: boolean) {
    if (this.trouble !== null) return Promise.reject(this.trouble);
    if (first > this.records.length || (first > 0 && first !== this.records.length)) {
      this.refused++;
      return Promise.reject(new ApiError("do not follow", "", 422));
    }
    if (first === 0) this.wholes++;
    this.records = [...this.records.slice(0, first), ...records];
    this.unsaved = unsaved;
    return Promise.resolve({ bytes: 1 });
  }
}

let kept: Kept;
let stop: () => void;
const failures: unknown[] = [];

async function open(path: string): Promise<void> {
  const found = recover((await claim(path))?.records ?? []);
  openWith(found?.history ?? null);
  useStudio.getState().openMission(file(path), found?.history);
}

beforeEach(async () => {
  kept = new Kept();
  failures.length = 0;
  stop = keepJournal(
    (cause) => failures.push(cause),
    () => undefined,
    kept.store,
  );
  await open("a.krt");
});
afterEach(() => stop());

function recovered() {
  const found = recover(kept.records);
  if (found === null) throw new Error("nothing was recovered");
  return found.history;
}

describe("the journal", () => {
  it("holds nothing while nothing was done", async () => {
    await flush();
    expect([kept.records, isKept()]).toEqual([[], true]);
  });

  it("holds every edit, and what undo would take back", async () => {
    edit();
    await flush();
    edit();
    edit();
    useStudio.getState().undo();
    expect(isKept()).toBe(false);
    await flush();
    expect([isKept(), kept.unsaved]).toEqual([true, true]);
    expect(recovered().mission).toEqual(useStudio.getState().mission);
    expect([recovered().past.length, recovered().future.length]).toEqual([2, 1]);
    expect(kept.wholes).toBe(1);
  });

  it("goes out by itself a moment later", async () => {
    edit();
    await vi.waitFor(() => expect(kept.records.length).toBeGreaterThan(0));
  });

  it("writes a drag as one step", async () => {
    edit();
    await flush();
    const before = kept.records.length;
    for (let step = 0; step < 20; step++) edit("drag");
    await flush();
    expect(kept.records.length).toBe(before + 1);
    expect(recovered().mission).toEqual(useStudio.getState().mission);
  });

  it("is saved when the file is, and knows where", async () => {
    edit();
    useStudio.getState().markSaved("b.krt", "r2");
    await flush();
    expect(kept.unsaved).toBe(false);
    expect(recover(kept.records)?.revision).toBe("r2");
    useStudio.getState().undo();
    await flush();
    expect(isUnsaved(recovered())).toBe(true);
  });

  it("brings a mission back with its undo and redo", async () => {
    edit();
    edit();
    edit();
    useStudio.getState().undo();
    await flush();
    const last = useStudio.getState().mission;
    stop();
    useStudio.getState().openMission(file(""));
    stop = keepJournal(
      () => undefined,
      () => undefined,
      kept.store,
    );
    await open("a.krt");
    const studio = useStudio.getState();
    expect(studio.mission).toEqual(last);
    expect([studio.dirty, studio.undoLabel, studio.redoLabel]).toEqual([
      true,
      `Edit ${String(number - 1)}`,
      `Edit ${String(number)}`,
    ]);
    while (useStudio.getState().canUndo) studio.undo();
    expect(useStudio.getState().mission).toEqual(MISSION);
    expect(useStudio.getState().dirty).toBe(false);
  });

  it("sends everything again when the server lost count, and says nothing", async () => {
    edit();
    await flush();
    kept.records.pop();
    edit();
    await flush();
    await flush();
    expect(recovered().mission).toEqual(useStudio.getState().mission);
    expect(failures).toEqual([]);
  });

  it("is not taken in by a save while records are on their way", async () => {
    edit();
    await flush();
    edit();
    useStudio.getState().undo();
    edit();
    const going = flush();
    useStudio.getState().markSaved("a.krt", "r2");
    await going;
    edit();
    await flush();
    expect(recovered().mission).toEqual(useStudio.getState().mission);
    expect([kept.refused, isKept()]).toEqual([0, true]);
  });

  it("says when it cannot be written, and mends it later", async () => {
    edit();
    kept.trouble = new ApiError("The disk is full.", "", 422);
    await flush();
    expect([failures.length, isKept()]).toEqual([1, false]);
    kept.trouble = null;
    await flush();
    expect(recovered().mission).toEqual(useStudio.getState().mission);
    expect(isKept()).toBe(true);
  });

  it("goes on after a lost connection", async () => {
    edit();
    await flush();
    kept.watcher?.onLost();
    edit();
    await flush();
    expect(isKept()).toBe(false);
    void kept.watcher?.onHello("tab-2");
    await vi.waitFor(() => expect(isKept()).toBe(true));
    expect(recovered().mission).toEqual(useStudio.getState().mission);
  });

  it("of the same file opened anew begins anew", async () => {
    edit();
    await flush();
    openWith((await claim("a.krt")) === null ? null : recovered());
    useStudio.getState().openMission(file("a.krt"));
    await flush();
    expect([kept.records, useStudio.getState().dirty]).toEqual([[], false]);
  });
});

describe("records", () => {
  it("cut anywhere give a state that once was", async () => {
    const seen = [JSON.stringify(MISSION)];
    let state = 5;
    for (let step = 0; step < 60; step++) {
      state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
      const studio = useStudio.getState();
      if (state % 7 < 2) studio.undo();
      else if (state % 7 === 2) studio.redo();
      else edit(state % 7 === 3 ? "typing" : undefined);
      seen.push(JSON.stringify(useStudio.getState().mission));
      if (state % 5 === 0) await flush();
    }
    await flush();
    for (let count = 1; count <= kept.records.length; count++) {
      expect(seen).toContain(JSON.stringify(recover(kept.records.slice(0, count))?.history.mission));
    }
    expect(recovered().mission).toEqual(useStudio.getState().mission);
  });

  it.each([[["rubbish"]], [['{"kind":"do"}']], [["null"]], [[""]], [[]]])(
    "that are none give nothing: %j",
    (records) => {
      expect(recover(records)).toBeNull();
    },
  );

  it("of which some are lost give the newest state that is known, and say what is missing", async () => {
    const seen = new Set([JSON.stringify(MISSION)]);
    for (let step = 0; step < 65; step++) {
      edit();
      seen.add(JSON.stringify(useStudio.getState().mission));
      await flush();
    }
    const { records } = kept;
    const last = JSON.stringify(useStudio.getState().mission);
    const bases = records.flatMap((one, at) => (one.startsWith('{"kind":"base"') ? [at] : []));
    expect(bases.length).toBeGreaterThan(2);
    for (let lost = 0; lost < records.length; lost++) {
      const found = recover(records.with(lost, ""));
      expect(seen).toContain(JSON.stringify(found?.history.mission));
      if (lost < (bases.at(-1) ?? 0)) {
        expect(JSON.stringify(found?.history.mission)).toBe(last);
        expect(found?.lost).toBe("steps");
        expect(found !== null && isUnsaved(found.history)).toBe(true);
      } else expect(found?.lost).toBe("last");
    }
    expect(recover(records)?.lost).toBeNull();
  });

  it("that do not fit are where it ends", async () => {
    edit();
    await flush();
    const odd = '{"kind":"do","label":"","program":"","saved":0,"delta":{"o":{"nothing":{"v":1}}}}';
    expect(recover([...kept.records, odd, odd])?.history).toEqual(recovered());
  });

  it("of a long history give up the oldest steps first", async () => {
    for (let step = 0; step < 50; step++) edit();
    await flush();
    const whole = recovered();
    const short = shortened(whole, "r", 4000);
    expect(short.past.length).toBeLessThan(whole.past.length);
    expect(recover(recordsOf(short, "r"))?.history).toEqual(short);
    expect([short.mission, isUnsaved(short)]).toEqual([whole.mission, true]);
  });
});
