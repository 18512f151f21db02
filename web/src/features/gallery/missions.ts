/** What can be opened: lists of missions and recordings, fetched when they are shown. */
import { api } from "../../api/client";
import type { OrphanedJournal, MissionEntry, RecordingEntry } from "../../api/generated";
import { journalApi } from "../../api/journal";
import { traceApi } from "../../api/traces";
import { reportError } from "../../session/document";
import { useFetched } from "../../ui/use-fetched";

function none(cause: unknown): never[] {
  reportError(cause);
  return [];
}

/** null while the list is on its way. */
export function useMissions(): MissionEntry[] | null {
  return useFetched<MissionEntry[]>(api.missions, none);
}

/** Unsaved work that is open in no page; null while the list is on its way. */
function useLeft(): OrphanedJournal[] | null {
  return useFetched<OrphanedJournal[]>(journalApi.left, none);
}

/** null while the list is on its way. */
function useRecordings(): RecordingEntry[] | null {
  return useFetched<RecordingEntry[]>(traceApi.all, none);
}

interface Openable {
  left: OrphanedJournal[];
  missions: MissionEntry[];
  recordings: RecordingEntry[];
}

/** All that can be opened; null until every list is there, so that none pushes what is below it away from the pointer. */
export function useOpenable(): Openable | null {
  const left = useLeft();
  const missions = useMissions();
  const recordings = useRecordings();
  return left === null || missions === null || recordings === null ? null : { left, missions, recordings };
}
