/** What can be opened, missions and recordings, asked for when somebody wants to see it. */
import { useEffect, useState } from "react";

import { api, type MissionEntry } from "../api/client";
import { journalApi, type Left } from "../api/journal";
import { type RecordingEntry, traceApi } from "../api/traces";
import { complain } from "./document";

/** null while the list is on its way. */
function useList<T>(ask: () => Promise<T[]>): T[] | null {
  const [list, setList] = useState<T[] | null>(null);
  useEffect(() => {
    let alive = true;
    ask().then(
      (found) => {
        if (alive) setList(found);
      },
      (cause: unknown) => {
        if (!alive) return;
        setList([]);
        complain(cause);
      },
    );
    return () => {
      alive = false;
    };
  }, [ask]);
  return list;
}

/** null while the list is on its way. */
export function useMissions(): MissionEntry[] | null {
  return useList(api.missions);
}

/** Unsaved work that nobody has open; empty while the list is on its way. */
export function useLeft(): Left[] {
  return useList(journalApi.left) ?? [];
}

/** Empty while the list is on its way. */
export function useRecordings(): RecordingEntry[] {
  return useList(traceApi.all) ?? [];
}
