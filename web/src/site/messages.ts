/** What the page and the worker with Python in it tell each other. */
import type { Parts } from "../api/site-parts";

/**
 * From the page: `begin` comes first, and once; the rest waits until Python is there. `pupil`: whose files they are, "" outside
 * of a class.
 */
export type ToWorker =
  | { kind: "begin"; base: string; parts: Parts; unpacker: MessagePort; pupil: string }
  | {
      kind: "fetch";
      id: number;
      method: string;
      address: string;
      headers: Record<string, string>;
      body: ArrayBuffer | string | null;
    }
  | { kind: "open"; id: number; address: string }
  | { kind: "say"; id: number; words: string | ArrayBuffer }
  | { kind: "close"; id: number };

/**
 * Whether the browser keeps what is written: `full` and `denied` say why not; `unread`: what was kept before could not be
 * read, and nothing is written over it.
 */
export type Keeping = "kept" | "full" | "denied" | "unread";

export type FromWorker =
  | { kind: "progress"; fetched: number; total: number }
  | { kind: "starting" }
  | { kind: "ready" }
  | { kind: "broken"; unfetched: boolean; reason: string }
  | { kind: "keeping"; keeping: Keeping }
  | { kind: "answer"; id: number; status: number; headers: [string, string][]; body: ArrayBuffer }
  | { kind: "failed"; id: number; reason: string }
  | { kind: "opened"; id: number }
  | { kind: "heard"; id: number; words: string | ArrayBuffer }
  | { kind: "closed"; id: number };
