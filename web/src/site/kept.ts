/**
 * The folder of missions in the browser's storage (IndexedDB behind Pyodide's file system): read once at the start, written
 * whole after each request that may have changed something.
 */
import type { PyodideInterface } from "pyodide";

import type { FromWorker, Keeping } from "./messages";

/** What is used of Emscripten's file system. */
interface Files {
  mkdirTree: (path: string) => void;
  mount: (kind: unknown, options: object, path: string) => void;
  syncfs: (reads: boolean, done: (cause: unknown) => void) => void;
  filesystems: { IDBFS: unknown };
}

/** The part of Pyodide's file system that the browser keeps. */
export class Kept {
  readonly #files: Files;
  readonly #tell: (message: FromWorker) => void;
  readonly #makeRoom: () => Promise<boolean>;
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
    } catch (cause) {
      this.#said(cause);
    }
  }

  async read(): Promise<void> {
    this.#said(await this.#sync(true));
  }

  /** Something may have been written; resolves once it is kept, or cannot be. */
  write(): Promise<void> {
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
      this.#said(cause);
    }
  }

  #sync(reads: boolean): Promise<unknown> {
    return new Promise((resolve) => {
      try {
        this.#files.syncfs(reads, (cause) => resolve(cause ?? null));
      } catch (cause) {
        resolve(cause);
      }
    });
  }

  #said(cause: unknown): void {
    if (cause !== null) this.#set(isFull(cause) ? "full" : "denied");
    else if (this.#keeping === "full") this.#set("kept");
  }

  #set(keeping: Keeping): void {
    if (this.#keeping === keeping) return;
    this.#keeping = keeping;
    this.#tell({ kind: "keeping", keeping });
  }
}

function isFull(cause: unknown): boolean {
  return /quota|full|abort/i.test(String((cause as { name?: unknown } | null)?.name));
}
