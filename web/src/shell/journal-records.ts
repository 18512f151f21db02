/**
 * The journal's records: a history as texts, and back.
 *
 * The first record is `base`, a whole mission; each of the others is one change of the store after it, with the mission as a
 * delta. Reading goes as far as the records fit together, so what it gives is always a state that once was. Left to others:
 * how records travel and where they are kept.
 */
import { delta, type Delta, patch, type Plain } from "../model/delta";
import { type Change, follow, type History, historyOf } from "../model/history";
import type { Mission } from "../model/types";

/** Where a mission was read from or written to. */
export interface Origin {
  path: string;
  name: string;
  revision: string;
}

/** A change and the mission before and after it, waiting to be written. */
export interface Entry {
  change: Change;
  before: Mission;
  after: Mission;
}

type JournalRecord = { kind: "base"; revision: string; mission: Mission } | (Change & { delta?: Delta });

export interface Recovered {
  /** The file's revision that the history began with, or was saved as. */
  revision: string;
  history: History;
}

// A mission is plain data; only its type does not say so.
const plain = (mission: Mission) => mission as unknown as Plain;

function text(record: JournalRecord): string {
  return JSON.stringify(record);
}

/** One change as a text. */
export function recordOf({ change, before, after }: Entry): string {
  return text(
    change.kind === "do" || change.kind === "join" ? { ...change, delta: delta(plain(before), plain(after)) } : change,
  );
}

/** A whole history as texts. */
export function recordsOf(history: History, revision: string): string[] {
  const { past, future, mission, saved } = history;
  const steps = [...past, ...[...future].reverse()];
  const first = steps[0]?.before ?? mission;
  const plainChange = (kind: Change["kind"], label = "", program = ""): Change => ({ kind, label, program, saved });
  return [
    text({ kind: "base", revision, mission: first }),
    ...steps.map(({ label, program, before, after }) =>
      recordOf({ change: plainChange("do", label, program), before, after }),
    ),
    ...future.map(() => text(plainChange("undo"))),
    text(plainChange("save")),
  ];
}

/** What the records tell, as far as they fit together; null when they tell nothing. */
export function recover(records: readonly string[]): Recovered | null {
  let found: Recovered | null = null;
  for (const one of records) {
    const further = readOn(found, one);
    if (further === null) break;
    found = further;
  }
  return found;
}

/** What one more record makes of it; null when it does not fit. */
function readOn(found: Recovered | null, one: string): Recovered | null {
  try {
    const record = JSON.parse(one) as JournalRecord;
    if (record.kind === "base") return { revision: record.revision, history: historyOf(record.mission) };
    return found === null ? null : { ...found, history: after(found.history, record) };
  } catch {
    return null;
  }
}

function after(history: History, { delta: change = null, ...told }: Change & { delta?: Delta }): History {
  const mission = patch(plain(history.mission), change) as unknown as Mission;
  return follow(history, told, mission);
}

/** A history of at most so many characters as records: the oldest steps are given up first. */
export function shortened(history: History, revision: string, most: number): History {
  let kept = history;
  while (kept.past.length > 1 && recordsOf(kept, revision).reduce((sum, one) => sum + one.length, 0) > most) {
    const gone = Math.ceil(kept.past.length / 2);
    const saved = kept.saved - gone;
    kept = { ...kept, past: kept.past.slice(gone), saved: saved < 0 ? -1 : saved };
  }
  return kept;
}
