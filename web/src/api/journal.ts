/** Routes of the journal: records are texts that the server does not read. */
import type { Mission } from "../model/types";
import { ask } from "./client";
import type { ClaimedJournal, Difference, JournalSize, OrphanedJournal, Merged } from "./generated";

const post = <T>(address: string, json: unknown) => ask<T>(address, { method: "POST", json });

export const journalApi = {
  claim: (tab: string, path: string, journal: string) => post<ClaimedJournal>("journal/claim", { tab, path, journal }),
  replace: (tab: string, path: string, name: string, records: string[], unsaved: boolean) =>
    ask<JournalSize>("journal", { method: "PUT", json: { tab, path, name, records, unsaved } }),
  append: (tab: string, first: number, records: string[], unsaved: boolean) =>
    post<JournalSize>("journal", { tab, first, records, unsaved }),
  left: () => ask<OrphanedJournal[]>("journal/left"),
  forget: (journal: string) => post<OrphanedJournal[]>("journal/forget", { journal }),
  merge: (path: string, base: Mission, mission: Mission, taken: readonly string[]) =>
    post<Merged>("mission/merge", { path, base, mission, taken }),
  difference: (path: string, mission: Mission) => post<Difference>("mission/difference", { path, mission }),
};
