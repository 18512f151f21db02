/**
 * The journal's records: a history as texts, and back.
 *
 * The first record is `base`, a whole mission; most of the others are one change of the store, with the mission as a delta.
 * Now and then there is another base. What reading gives is always a state that once was. Left to others:
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

type JournalRecord = { kind: "base"; revision: string; mission: Mission } | ChangeRecord;
type ChangeRecord = Change & { delta?: Delta };

export interface Recovered {
  /** The file's revision that the history began with, or was saved as. */
  revision: string;
  history: History;
  /** What is missing: the last changes, or only steps that could have been taken back. */
  lost: "last" | "steps" | null;
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
    baseOf(first, revision),
    ...steps.map(({ label, program, before, after }) =>
      recordOf({ change: plainChange("do", label, program), before, after }),
    ),
    ...future.map(() => text(plainChange("undo"))),
    text(plainChange("save")),
  ];
}

/** A whole mission as a text: where reading goes on when a record before it was lost. */
export function baseOf(mission: Mission, revision: string): string {
  return text({ kind: "base", revision, mission });
}

/**
 * What the records hold; null when they hold nothing.
 *
 * A change depends on all before it, back to a `base`. Where one is lost or does not fit, what follows it counts again from
 * the next base on: the mission as it was then, without the steps before.
 */
export function recover(records: readonly string[]): Recovered | null {
  let found: Recovered | null = null;
  let broken = false;
  let rebased = false;
  for (const one of records) {
    const record = parsed(one);
    if (record?.kind === "base") {
      if (found !== null && !broken) continue;
      rebased ||= broken;
      found = { revision: record.revision, history: historyOf(record.mission), lost: null };
      broken = false;
    } else {
      const further = readOn(broken ? null : found, record, rebased);
      if (further === null) broken = true;
      else found = further;
    }
  }
  if (found === null) return null;
  // Which state of it was saved cannot be said any more.
  const history = rebased ? { ...found.history, saved: -1 } : found.history;
  return { ...found, history, lost: broken ? "last" : rebased ? "steps" : null };
}

function parsed(one: string): JournalRecord | null {
  try {
    const record: unknown = JSON.parse(one);
    return typeof record === "object" && record !== null && "kind" in record ? (record as JournalRecord) : null;
  } catch {
    return null;
  }
}

/** What one more change makes of it; null when it does not fit. */
function readOn(found: Recovered | null, record: ChangeRecord | null, rebased: boolean): Recovered | null {
  if (found === null || record === null) return null;
  const { history } = found;
  const { delta: change = null, ...told } = record;
  const nowhere =
    (told.kind === "undo" && history.past.length === 0) || (told.kind === "redo" && history.future.length === 0);
  if (rebased && nowhere) return null;
  try {
    const mission = patch(plain(history.mission), change) as unknown as Mission;
    return { ...found, history: follow(history, told, mission) };
  } catch {
    return null;
  }
}

/** A history of at most so many characters as records, as far as that can be: the oldest steps are given up first. */
export function shortened(history: History, revision: string, most: number): History {
  const long = (one: History) => recordsOf(one, revision).reduce((sum, text) => sum + text.length, 0) > most;
  let kept = history;
  while (kept.past.length > 0 && long(kept)) {
    const gone = Math.ceil(kept.past.length / 2);
    const saved = kept.saved - gone;
    kept = { ...kept, past: kept.past.slice(gone), saved: saved < 0 ? -1 : saved };
  }
  if (kept.future.length === 0 || !long(kept)) return kept;
  return { ...kept, future: [], saved: kept.saved > kept.past.length ? -1 : kept.saved };
}
