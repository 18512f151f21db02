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

type Fail = (cause: unknown, again: () => void) => void;

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

/** Whether the browser keeps what is done; a static site says so. */
export function setKept(kept: boolean): void {
  useLink.setState({ kept });
}

/** Whether nothing that is done here reaches the server at the moment. */
export function isCutOff({ connected, silent }: Link): boolean {
  return connected === false || silent;
}

/** The journal that this tab wrote before it was loaded again. */
export function journalBefore(): string {
  try {
    return sessionStorage.getItem(KEY) ?? "";
  } catch {
    return "";
  }
}

/** The journal of this page, as long as it is kept. */
class Journal {
  readonly #store: Store;
  readonly #fail: Fail;
  #tab = "";
  #journal = "";
  #waiting: Entry[] = [];
  /** Records that the server has; -1 when it must be sent everything. */
  #sent = 0;
  /** How often everything was asked for: what is on its way meanwhile says nothing about how far the server is. */
  #asked = 0;
  /** Changes since the last whole mission. */
  #sinceBase = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #sending: Promise<void> | null = null;
  /** Between the claim and the opening nothing may go out: it would be the old mission's, in the new one's journal. */
  #opening = false;
  #greeted: (() => void)[] = [];

  constructor(store: Store, fail: Fail) {
    this.#store = store;
    this.#fail = fail;
  }

  #remember(name: string): void {
    this.#journal = name;
    try {
      sessionStorage.setItem(KEY, name);
    } catch {
      // Then a reload begins with the first mission, and the work is on its own.
    }
  }

  /** The whole history must be sent: what the server has is unknown. */
  #sendAll(): void {
    this.#sent = -1;
    this.#asked++;
  }

  /** Whether everything that was done is on the server's disk. */
  isKept(): boolean {
    return this.#waiting.length === 0 && this.#sending === null && this.#sent >= 0;
  }

  /** Claims the journal for a mission that is about to be opened; null without a server that keeps one. */
  async claim(path: string, wanted = ""): Promise<ClaimedJournal | null> {
    await this.flush();
    if (this.#tab === "") await this.#hello();
    if (this.#tab === "") return null;
    const { file } = useStudio.getState();
    // The same mission once more: what is on disk is wanted, not what was done to it here.
    if (wanted === "" && this.#journal !== "" && path !== "" && path === file.path) {
      this.#sendAll();
      return null;
    }
    try {
      this.#opening = true;
      const claimed = await this.#store.api.claim(this.#tab, path, wanted);
      this.#remember(claimed.journal);
      this.#sent = claimed.records.length;
      return claimed;
    } catch (cause) {
      this.#opening = false;
      if (cause instanceof ApiError && cause.status !== 0) return null;
      throw cause;
    }
  }

  /** A mission is opened next; where it has a history already the journal is written anew from it. */
  openWith(begin: History | null): void {
    if (begin !== null || this.#sent > 0) this.#sendAll();
  }

  /** The mission that was open before the claim stays open: the journal is written from what was done to it meanwhile. */
  keepOpen(): void {
    this.#opening = false;
    this.#sendAll();
    void this.flush();
  }

  #hello(): Promise<void> {
    return new Promise((resolve) => {
      const late = setTimeout(resolve, HELLO_WITHIN_MS);
      this.#greeted.push(() => {
        clearTimeout(late);
        resolve();
      });
    });
  }

  record(after: Mission, before: Mission): void {
    const { change } = useStudio.getState();
    if (change.kind === "open") {
      this.#opening = false;
      this.#waiting = [];
      // At once: discarded work must not come back when the page is left now.
      if (this.#sent < 0) void this.flush();
      return;
    }
    const last = this.#waiting.at(-1);
    if (change.kind === "join" && last !== undefined && (last.change.kind === "do" || last.change.kind === "join")) {
      this.#waiting[this.#waiting.length - 1] = {
        change: { ...change, kind: last.change.kind },
        before: last.before,
        after,
      };
    } else {
      this.#waiting.push({ change, before, after });
    }
    if (change.kind === "save") {
      // At once: the file's name may be another one now, and a page that is loaded again must find it.
      this.#sendAll();
      void this.flush();
    } else this.#soon();
  }

  #soon(): void {
    this.#timer ??= setTimeout(() => {
      this.#timer = undefined;
      void this.flush();
    }, QUIET_MS);
  }

  /** Sends what waits. Resolves when it is on disk, or cannot be. */
  async flush(): Promise<void> {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    while (this.#sending !== null) await this.#sending;
    if (this.#opening || this.#tab === "" || this.#journal === "" || (this.#waiting.length === 0 && this.#sent >= 0))
      return;
    this.#sending = this.#send().finally(() => {
      this.#sending = null;
    });
    await this.#sending;
  }

  async #send(): Promise<void> {
    const { file, history } = useStudio.getState();
    const batch = this.#waiting;
    const first = this.#sent;
    const whole = first <= 0;
    const asking = this.#asked;
    try {
      if (whole) {
        const kept = shortened(history, file.revision, LARGEST / 2);
        const empty = kept.past.length === 0 && kept.future.length === 0 && !isUnsaved(kept);
        const records = empty ? [] : recordsOf(kept, file.revision);
        this.#waiting = [];
        await this.#store.api.replace(this.#tab, file.path, file.name, records, isUnsaved(kept));
        this.#sinceBase = records.length;
        if (this.#asked === asking) this.#sent = records.length;
      } else {
        const records = batch.map(recordOf);
        this.#waiting = [];
        this.#sinceBase += batch.length;
        const base = this.#sinceBase < BASE_EVERY ? "" : baseOf(batch.at(-1)?.after ?? history.mission, file.revision);
        if (base !== "" && base.length < LARGEST / 4) {
          records.push(base);
          this.#sinceBase = 0;
        }
        const { bytes } = await this.#store.api.append(this.#tab, first, records, isUnsaved(history));
        if (this.#asked === asking) this.#sent = bytes > LARGEST ? -1 : first + records.length;
      }
    } catch (cause) {
      this.#sendAll();
      // A lost connection is reported by the checker; the whole history is sent when it is back.
      if (!(cause instanceof ApiError) || cause.status === 0) return;
      if (whole) this.#fail(cause, () => this.#soon());
      else this.#soon();
    }
  }

  /** A new connection: the journal is claimed again, and sent whole, since what was lost is unknown. */
  async greet(name: string): Promise<void> {
    const again = this.#tab === "" && this.#journal !== "";
    this.#tab = name;
    for (const tell of this.#greeted.splice(0)) tell();
    if (!again) return;
    try {
      const claimed = await this.#store.api.claim(this.#tab, useStudio.getState().file.path, this.#journal);
      this.#remember(claimed.journal);
      this.#sendAll();
      await this.flush();
    } catch {
      this.#sendAll();
    }
  }

  /** The connection is gone: the next one has another name. */
  disconnect(): void {
    this.#tab = "";
  }

  end(): void {
    clearTimeout(this.#timer);
  }
}

/** The journal that is kept now. */
let current: Journal | null = null;

/** Whether a journal is kept. */
export function keepsJournal(): boolean {
  return current !== null;
}

/** Whether everything that was done is on the server's disk. */
export function isKept(): boolean {
  return current?.isKept() ?? false;
}

/** Claims the journal for a mission that is about to be opened; null without a server that keeps one. */
export async function claim(path: string, wanted = ""): Promise<ClaimedJournal | null> {
  return (await current?.claim(path, wanted)) ?? null;
}

/** A mission is opened next; where it has a history already the journal is written anew from it. */
export function openWith(begin: History | null): void {
  current?.openWith(begin);
}

/** The mission that was open before the claim stays open: the journal is written from what was done to it meanwhile. */
export function keepOpen(): void {
  current?.keepOpen();
}

/** Sends what waits. Resolves when it is on disk, or cannot be. */
export async function flush(): Promise<void> {
  await current?.flush();
}

/** Starts keeping the journal; the returned function ends it. */
export function keepJournal(
  fail: Fail,
  onNews: (news: News) => void,
  store: Store = { api: journalApi, watch: openWatch },
  { onReturn, onStranger }: Pick<Watcher, "onReturn" | "onStranger"> = NOBODY_HEARS,
): () => void {
  const journal = new Journal(store, fail);
  current = journal;
  const close = store.watch({
    onHello: (name) => {
      useLink.setState({ connected: true });
      return journal.greet(name);
    },
    onNews,
    onReturn,
    onStranger,
    onLost: () => {
      journal.disconnect();
      useLink.setState({ connected: false, silent: false });
    },
    onSilence: (silent) => useLink.setState({ silent }),
  });
  const off = useStudio.subscribe((state, before) => {
    if (state.change !== before.change) journal.record(state.mission, before.mission);
  });
  return () => {
    off();
    close();
    journal.end();
    current = null;
  };
}
