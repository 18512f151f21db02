/**
 * The folder of missions in the browser's storage (IndexedDB behind Pyodide's file system): read once at the start, written
 * whole after each request that may have changed something.
 *
 * What could not be read is never written: a folder that is empty because of a fault would delete what is kept.
 */
import type { PyodideInterface } from "pyodide";

import type { FromWorker, Keeping } from "./messages";

/** What is used of Emscripten's file system. */
interface Files {
  mkdirTree: (path: string) => void;
  mount: (kind: unknown, options: object, path: string) => void;
  syncfs: (reads: boolean, done: (cause: unknown) => void) => void;
  filesystems: { IDBFS: { quit: () => void } };
}

/** The part of Pyodide's file system that the browser keeps. */
export class Kept {
  readonly #files: Files;
  readonly #tell: (message: FromWorker) => void;
  readonly #makeRoom: () => Promise<boolean>;
  #mounted = false;
  #wasRead = false;
  #changed = false;
  #writing: Promise<void> | null = null;
  #keeping: Keeping = "kept";

  /** `makeRoom` throws away what is not needed; whether there was something. */
  constructor(
    pyodide: PyodideInterface,
    home: string,
    tell: (message: FromWorker) => void,
    makeRoom: () => Promise<boolean>,
  ) {
    const files = pyodide.FS as unknown as Files;
    this.#files = files;
    this.#tell = tell;
    this.#makeRoom = makeRoom;
    files.mkdirTree(home);
    try {
      files.mount(files.filesystems.IDBFS, {}, home);
      this.#mounted = true;
    } catch {
      this.#said("denied");
    }
  }

  async read(): Promise<void> {
    if (!this.#mounted) return;
    const cause = await this.#sync(true);
    this.#wasRead = cause === null;
    if (cause !== null) this.#said(isDenied(cause) ? "denied" : "unread");
  }

  /** Something may have been written; resolves once it is kept, or cannot be. */
  write(): Promise<void> {
    if (!this.#wasRead) return Promise.resolve();
    this.#changed = true;
    this.#writing ??= this.#writeAll().finally(() => {
      this.#writing = null;
    });
    return this.#writing;
  }

  async #writeAll(): Promise<void> {
    while (this.#changed) {
      this.#changed = false;
      let cause = await this.#sync(false);
      if (isFull(cause) && (await this.#makeRoom())) cause = await this.#sync(false);
      if (cause === null) this.#said("kept");
      else this.#said(isFull(cause) ? "full" : "denied");
    }
  }

  /** Why it failed, or null. A connection that the browser has closed is opened anew, once. */
  async #sync(reads: boolean): Promise<unknown> {
    const cause = await this.#syncOnce(reads);
    if (cause === null || isFull(cause)) return cause;
    this.#files.filesystems.IDBFS.quit();
    return this.#syncOnce(reads);
  }

  #syncOnce(reads: boolean): Promise<unknown> {
    return new Promise((resolve) => {
      try {
        this.#files.syncfs(reads, (cause) => resolve(cause ?? null));
      } catch (cause) {
        resolve(cause);
      }
    });
  }

  #said(keeping: Keeping): void {
    if (this.#keeping === keeping) return;
    this.#keeping = keeping;
    this.#tell({ kind: "keeping", keeping });
  }
}

const nameOf = (cause: unknown) => String((cause as { name?: unknown } | null)?.name);

function isFull(cause: unknown): boolean {
  return /quota|full|abort/i.test(nameOf(cause));
}

/** Whether there is no storage at all, as in private windows of some browsers. */
function isDenied(cause: unknown): boolean {
  return typeof cause === "string" || /security|invalidstate|reference|type/i.test(nameOf(cause));
}
