/** What can be opened: lists of missions and recordings, fetched when they are shown. */
import { useEffect, useState } from "react";

import { api } from "../../api/client";
import type { Left, MissionEntry, RecordingEntry } from "../../api/generated";
import { journalApi } from "../../api/journal";
import { traceApi } from "../../api/traces";
import { complain } from "../../session/document";

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

/** Unsaved work that is open in no page; empty while the list is on its way. */
export function useLeft(): Left[] {
  return useList(journalApi.left) ?? [];
}

/** Empty while the list is on its way. */
export function useRecordings(): RecordingEntry[] {
  return useList(traceApi.all) ?? [];
}
