/** The journal's doors: what the page did travels as texts that only the page understands. */
import { ask } from "./client";
import type { Mission } from "./types";

export interface Claimed {
  journal: string;
  path: string;
  name: string;
  records: string[];
  damaged: boolean;
}

export interface Left {
  journal: string;
  path: string;
  name: string;
  modified: string;
}

export interface Difference {
  revision: string;
  changes: string[];
}

export interface JournalSize {
  bytes: number;
}

const post = <T>(address: string, json: unknown) => ask<T>(address, { method: "POST", json });

export const journalApi = {
  claim: (tab: string, path: string, journal: string) => post<Claimed>("journal/claim", { tab, path, journal }),
  replace: (tab: string, path: string, name: string, records: string[], unsaved: boolean) =>
    ask<JournalSize>("journal", { method: "PUT", json: { tab, path, name, records, unsaved } }),
  append: (tab: string, first: number, records: string[], unsaved: boolean) =>
    post<JournalSize>("journal", { tab, first, records, unsaved }),
  left: () => ask<Left[]>("journal/left"),
  forget: (journal: string) => post<Left[]>("journal/forget", { journal }),
  difference: (path: string, mission: Mission) => post<Difference>("mission/difference", { path, mission }),
};
