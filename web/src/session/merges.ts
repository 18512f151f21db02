/**
 * Merges of the open mission with its file: what both began with, and which revision of the file a mission has taken in.
 *
 * A merge is a step like others, so undo takes it back; then what was merged is not taken in any more, and saving asks
 * again. Known until the page is loaded anew.
 */
import type { History } from "../model/history";
import { useStudio } from "../model/studio";
import type { Mission } from "../model/types";

interface Merge {
  /** The revision that was replaced by the other one on disk, which the mission has taken in. */
  from: string;
  to: string;
  /** The mission on disk. */
  theirs: Mission;
}

/** By the mission that came of each. */
const merges = new WeakMap<Mission, Merge>();

export function keepMerge(mission: Mission, merge: Merge): void {
  merges.set(mission, merge);
}

/** The mission as it was read or written last; null when no step leads there any more. */
function savedState({ mission, past, future, saved }: History): Mission | null {
  if (saved < 0) return null;
  if (saved < past.length) return past[saved]?.before ?? null;
  return saved === past.length ? mission : (future.at(past.length - saved)?.after ?? null);
}

/** The last version of the file that the mission has taken in, and its revision. */
function taken(history: History, revision: string): { revision: string; base: Mission | null } {
  let found = { revision, base: savedState(history) };
  for (const { after } of history.past) {
    const merge = merges.get(after);
    if (merge?.from === found.revision) found = { revision: merge.to, base: merge.theirs };
  }
  return found;
}

/** The revision of the file that a save may replace. */
export function revisionMerged(): string {
  const { history, file } = useStudio.getState();
  return taken(history, file.revision).revision;
}

/** What the open mission and its file have both begun with; null when that is not known. */
export function commonBase(): Mission | null {
  const { history, file } = useStudio.getState();
  return taken(history, file.revision).base;
}
