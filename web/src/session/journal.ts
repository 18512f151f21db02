/**
 * Keeps the journal: everything that happens to the document is on the server's disk a moment later.
 *
 * The page is a tab as long as its socket is open and writes one journal, which it claims when it opens a mission. Changes
 * wait `QUIET_MS` and go out together, one request at a time. Where the server's journal and ours may not agree (a lost
 * connection, a failure, a save, too many bytes) the whole history is sent in its place. Left to others: what the person is
 * told of it (`journal-notices.ts`, `disk.ts`).
 */
import { create } from "zustand";

import { ApiError } from "../api/client";
import type { ClaimedJournal } from "../api/generated";
import { journalApi } from "../api/journal";
import { type News, openWatch, type Watcher } from "../api/watch";
import { type History, isUnsaved } from "../model/history";
import { useStudio } from "../model/studio";
import type { Mission } from "../model/types";
import { baseOf, type Entry, recordOf, recordsOf, shortened } from "./journal-records";

export const QUIET_MS = 250;
const HELLO_WITHIN_MS = 4000;
const LARGEST = 4_000_000;
/** Changes after which a whole mission is written once more: a damage of the journal costs no change behind the next. */
const BASE_EVERY = 20;
const KEY = "kitrobot.journal";
const NOBODY_HEARS = { onReturn: () => undefined, onStranger: () => undefined };

/** How the journal reaches the server; tests bring their own. */
export interface Store {
  api: Pick<typeof journalApi, "claim" | "replace" | "append">;
  watch: typeof openWatch;
}

interface Keeping {
  store: Store;
  fail: (cause: unknown, again: () => void) => void;
}

/** Where what is done here is kept. */
interface Link {
  /** Whether the server that keeps the journal is there; null before it was asked. */
  connected: boolean | null;
  /** Whether it does not answer, though the connection to it is open. */
  silent: boolean;
  /** Whether what it writes outlasts the page: not in a browser without room for it. */
  kept: boolean;
}

export const useLink = create<Link>(() => ({ connected: null, silent: false, kept: true }));

/** Whether nothing that is done here reaches the server at the moment. */
export function isCutOff({ connected, silent }: Link): boolean {
  return connected === false || silent;
}

let keeping: Keeping | null = null;
let tab = "";
let journal = "";
let waiting: Entry[] = [];
/** Records that the server has; -1 when it must be sent everything. */
let sent = 0;
/** How often everything was asked for: what is on its way meanwhile says nothing about how far the server is. */
let asked = 0;
/** Changes since the last whole mission. */
let sinceBase = 0;
let timer: ReturnType<typeof setTimeout> | undefined;
let sending: Promise<void> | null = null;
/** Between the claim and the opening nothing may go out: it would be the old mission's, in the new one's journal. */
let opening = false;
let greeted: (() => void)[] = [];

/** The journal that this tab wrote before it was loaded again. */
export function journalBefore(): string {
  try {
    return sessionStorage.getItem(KEY) ?? "";
  } catch {
    return "";
  }
}

function remember(name: string): void {
  journal = name;
  try {
    sessionStorage.setItem(KEY, name);
  } catch {
    // Then a reload begins with the first mission, and the work is on its own.
  }
}

/** The whole history must be sent: what the server has is unknown. */
function sendAll(): void {
  sent = -1;
  asked++;
}

/** Whether a journal is kept. */
export function keepsJournal(): boolean {
  return keeping !== null;
}

/** Whether everything that was done is on the server's disk. */
export function isKept(): boolean {
  return keeping !== null && waiting.length === 0 && sending === null && sent >= 0;
}

/** Claims the journal for a mission that is about to be opened; null without a server that keeps one. */
export async function claim(path: string, wanted = ""): Promise<ClaimedJournal | null> {
  if (keeping === null) return null;
  await flush();
  if (tab === "") await hello();
  if (tab === "") return null;
  const { file } = useStudio.getState();
  // The same mission once more: what is on disk is wanted, not what was done to it here.
  if (wanted === "" && journal !== "" && path !== "" && path === file.path) {
    sendAll();
    return null;
  }
  try {
    opening = true;
    const claimed = await keeping.store.api.claim(tab, path, wanted);
    remember(claimed.journal);
    sent = claimed.records.length;
    return claimed;
  } catch (cause) {
    opening = false;
    if (cause instanceof ApiError && cause.status !== 0) return null;
    throw cause;
  }
}

/** A mission is opened next; where it has a history already the journal is written anew from it. */
export function openWith(begin: History | null): void {
  if (begin !== null || sent > 0) sendAll();
}

function hello(): Promise<void> {
  return new Promise((resolve) => {
    const late = setTimeout(resolve, HELLO_WITHIN_MS);
    greeted.push(() => {
      clearTimeout(late);
      resolve();
    });
  });
}

function heard(after: Mission, before: Mission): void {
  const { change } = useStudio.getState();
  if (change.kind === "open") {
    opening = false;
    waiting = [];
    // At once: discarded work must not come back when the page is left now.
    if (sent < 0) void flush();
    return;
  }
  const last = waiting.at(-1);
  if (change.kind === "join" && last !== undefined && (last.change.kind === "do" || last.change.kind === "join")) {
    waiting[waiting.length - 1] = { change: { ...change, kind: last.change.kind }, before: last.before, after };
  } else {
    waiting.push({ change, before, after });
  }
  if (change.kind === "save") {
    // At once: the file's name may be another one now, and a page that is loaded again must find it.
    sendAll();
    void flush();
  } else soon();
}

function soon(): void {
  timer ??= setTimeout(() => {
    timer = undefined;
    void flush();
  }, QUIET_MS);
}

/** Sends what waits. Resolves when it is on disk, or cannot be. */
export async function flush(): Promise<void> {
  clearTimeout(timer);
  timer = undefined;
  while (sending !== null) await sending;
  if (keeping === null || opening || tab === "" || journal === "" || (waiting.length === 0 && sent >= 0)) return;
  sending = send(keeping).finally(() => {
    sending = null;
  });
  await sending;
}

async function send({ store, fail }: Keeping): Promise<void> {
  const { file, history } = useStudio.getState();
  const batch = waiting;
  const first = sent;
  const whole = first <= 0;
  const asking = asked;
  try {
    if (whole) {
      const kept = shortened(history, file.revision, LARGEST / 2);
      const empty = kept.past.length === 0 && kept.future.length === 0 && !isUnsaved(kept);
      const records = empty ? [] : recordsOf(kept, file.revision);
      waiting = [];
      await store.api.replace(tab, file.path, file.name, records, isUnsaved(kept));
      sinceBase = records.length;
      if (asked === asking) sent = records.length;
    } else {
      const records = batch.map(recordOf);
      waiting = [];
      sinceBase += batch.length;
      const base = sinceBase < BASE_EVERY ? "" : baseOf(batch.at(-1)?.after ?? history.mission, file.revision);
      if (base !== "" && base.length < LARGEST / 4) {
        records.push(base);
        sinceBase = 0;
      }
      const { bytes } = await store.api.append(tab, first, records, isUnsaved(history));
      if (asked === asking) sent = bytes > LARGEST ? -1 : first + records.length;
    }
  } catch (cause) {
    sendAll();
    // A lost connection is reported by the checker; the whole history is sent when it is back.
    if (!(cause instanceof ApiError) || cause.status === 0) return;
    if (whole) fail(cause, soon);
    else soon();
  }
}

/** A new connection: the journal is claimed again, and sent whole, since what was lost is unknown. */
async function greet(name: string): Promise<void> {
  const again = tab === "" && journal !== "";
  tab = name;
  for (const tell of greeted.splice(0)) tell();
  if (!again || keeping === null) return;
  try {
    const claimed = await keeping.store.api.claim(tab, useStudio.getState().file.path, journal);
    remember(claimed.journal);
    sendAll();
    await flush();
  } catch {
    sendAll();
  }
}

/** Starts keeping the journal; the returned function ends it. */
export function keepJournal(
  fail: Keeping["fail"],
  onNews: (news: News) => void,
  store: Store = { api: journalApi, watch: openWatch },
  { onReturn, onStranger }: Pick<Watcher, "onReturn" | "onStranger"> = NOBODY_HEARS,
): () => void {
  const close = store.watch({
    onHello: (name) => {
      useLink.setState({ connected: true });
      return greet(name);
    },
    onNews,
    onReturn,
    onStranger,
    onLost: () => {
      tab = "";
      useLink.setState({ connected: false, silent: false });
    },
    onSilence: (silent) => useLink.setState({ silent }),
  });
  const off = useStudio.subscribe((state, before) => {
    if (state.change !== before.change) heard(state.mission, before.mission);
  });
  const stop = () => {
    off();
    close();
    clearTimeout(timer);
    [keeping, tab, journal, waiting, sent, timer, greeted, opening] = [null, "", "", [], 0, undefined, [], false];
  };
  keeping = { store, fail };
  return stop;
}
