/**
 * The worker of a static site: Pyodide with the same Python in it that `kitrobot` serves, called instead of asked over a network.
 *
 * Large files travel packed (gzip) and are unpacked here, so that it does not matter whether a server compresses. The folder
 * of missions lies in the browser's storage (IndexedDB behind Pyodide's file system): read once at the start, written after
 * each request that may have changed something; a save is answered once it is kept. One worker at a time has it (`open`).
 */
import type { loadPyodide as Load, PyodideInterface } from "pyodide";

import type { FromWorker, Keeping, ToWorker } from "./messages";

/** What `site.json` says: files that Python needs, with their sizes as they travel. */
interface Parts {
  pyodide: string;
  packages: string;
  /** Where packages belong in Pyodide. */
  place: string;
  files: Record<string, number>;
}

/** What is used of Emscripten's file system. */
interface Files {
  mkdirTree: (path: string) => void;
  mount: (kind: unknown, options: object, path: string) => void;
  syncfs: (reads: boolean, done: (cause: unknown) => void) => void;
  filesystems: { IDBFS: unknown };
}

interface Socket {
  say: (words: string) => void;
  close: () => void;
  destroy: () => void;
}

interface Studio {
  fetch: (
    method: string,
    address: string,
    headers: Record<string, string>,
    body: Uint8Array,
  ) => Promise<[number, [string, string][], Uint8Array<ArrayBuffer>]>;
  open: (address: string, heard: (words: string | Uint8Array<ArrayBuffer> | undefined) => void) => Socket;
}

const PACKED = ".packed";
/** Requests that only ask, though they are no GET. */
const ASKS = /^\/api\/(again|check|fragment|image|mission\/(difference|read|team|text)|text|exercise)/;

const scope = self as unknown as {
  postMessage: (message: FromWorker, transfer?: Transferable[]) => void;
  addEventListener: (type: "message", heard: (event: MessageEvent<ToWorker>) => void) => void;
  fetch: typeof fetch;
};
const network = scope.fetch.bind(self);
const tell = (message: FromWorker, transfer: Transferable[] = []) => scope.postMessage(message, transfer);

class UnfetchedError extends Error {}

/** Fetches the parts of the site, and says how far it is. */
class Fetching {
  readonly #base: string;
  readonly #files: Record<string, number>;
  readonly #total: number;
  #fetched = 0;
  #told = 0;

  constructor(base: string, files: Record<string, number>) {
    this.#base = base;
    this.#files = files;
    this.#total = Object.values(files).reduce((sum, one) => sum + one, 0);
  }

  has(name: string): boolean {
    return Object.hasOwn(this.#files, name);
  }

  /** The bytes of a file, unpacked. */
  async get(name: string): Promise<ReadableStream<Uint8Array<ArrayBuffer>>> {
    const packed = this.has(name + PACKED) ? name + PACKED : name;
    const response = await network(new URL(packed, this.#base)).catch(() => null);
    if (!response?.ok || response.body === null) throw new UnfetchedError(packed);
    const counted = response.body.pipeThrough(
      new TransformStream<Uint8Array<ArrayBuffer>, Uint8Array<ArrayBuffer>>({
        transform: (chunk, out) => {
          this.#count(chunk.length);
          out.enqueue(chunk);
        },
      }),
    );
    return packed === name ? counted : counted.pipeThrough(new DecompressionStream("gzip"));
  }

  #count(bytes: number): void {
    this.#fetched += bytes;
    if (this.#fetched < this.#told + this.#total / 100 && this.#fetched < this.#total) return;
    this.#told = this.#fetched;
    tell({ kind: "progress", fetched: this.#fetched, total: this.#total });
  }
}

async function load(base: string): Promise<[PyodideInterface, Studio]> {
  const said = await network(new URL("site.json", base)).catch(() => null);
  if (!said?.ok) throw new UnfetchedError("site.json");
  const { pyodide: place, packages, place: into, files } = (await said.json()) as Parts;
  const fetching = new Fetching(base, files);
  // Pyodide fetches its own files by their names.
  scope.fetch = async (asked, options) => {
    const address = asked instanceof Request ? asked.url : String(asked);
    const name = address.startsWith(base) ? address.slice(base.length) : "";
    if (!fetching.has(name + PACKED)) return network(asked, options);
    const type = name.endsWith(".wasm") ? "application/wasm" : "application/octet-stream";
    return new Response(await fetching.get(name), { headers: { "Content-Type": type } });
  };
  const bytes = fetching.get(packages).then((stream) => new Response(stream).arrayBuffer());
  // Whoever waits for Pyodide first hears of it too.
  bytes.catch(() => undefined);
  const indexURL = base + place;
  const home = `/home/${encodeURIComponent(new URL(base).pathname)}`;
  const { loadPyodide } = (await import(/* @vite-ignore */ `${indexURL}pyodide.mjs`)) as { loadPyodide: typeof Load };
  const pyodide = await loadPyodide({
    indexURL,
    env: { HOME: home, KITROBOT_STATE: `${home}/state`, KITROBOT_COMPILE: "no" },
  });
  const archive = await bytes;
  tell({ kind: "starting" });
  pyodide.unpackArchive(archive, "tar", { extractDir: into });
  keep.begin(pyodide, home);
  await keep.read();
  const { begin_here } = pyodide.pyimport("kitrobot.server.in_worker") as { begin_here: (folder: string) => Studio };
  return [pyodide, begin_here(`${home}/missions`)];
}

/** The part of Pyodide's file system that the browser keeps. */
class Kept {
  #files: Files | null = null;
  #changed = false;
  #writing: Promise<void> | null = null;
  #keeping: Keeping = "kept";

  begin(pyodide: PyodideInterface, home: string): void {
    const files = pyodide.FS as unknown as Files;
    this.#files = files;
    files.mkdirTree(home);
    try {
      files.mount(files.filesystems.IDBFS, {}, home);
    } catch (cause) {
      this.#failed(cause);
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
      this.#said(await this.#sync(false));
    }
  }

  #sync(reads: boolean): Promise<unknown> {
    return new Promise((resolve) => {
      try {
        this.#files?.syncfs(reads, (cause) => resolve(cause ?? null));
      } catch (cause) {
        resolve(cause);
      }
    });
  }

  #said(cause: unknown): void {
    if (cause !== null) this.#failed(cause);
    else if (this.#keeping === "full") this.#set("kept");
  }

  #failed(cause: unknown): void {
    const name = cause instanceof DOMException ? cause.name : String(cause);
    this.#set(/quota|full|abort/i.test(name) ? "full" : "denied");
  }

  #set(keeping: Keeping): void {
    if (this.#keeping === keeping) return;
    this.#keeping = keeping;
    tell({ kind: "keeping", keeping });
  }
}

const keep = new Kept();
const sockets = new Map<number, Socket>();
let studio: Promise<Studio> | null = null;

async function answer(message: ToWorker & { kind: "fetch" }): Promise<void> {
  const { id, method, address, headers, body } = message;
  try {
    const bytes = typeof body === "string" ? new TextEncoder().encode(body) : new Uint8Array(body ?? []);
    const [status, told, made] = await (await ready()).fetch(method, address, headers, bytes);
    if (method === "PUT") await keep.write();
    else if (method !== "GET" && !ASKS.test(address)) void keep.write();
    tell({ kind: "answer", id, status, headers: told, body: made.buffer }, [made.buffer]);
  } catch (cause) {
    // The page says that it has no answer; here stands why.
    console.error(cause);
    tell({ kind: "failed", id, reason: String(cause) });
  }
}

function ready(): Promise<Studio> {
  return studio ?? Promise.reject(new Error("nothing was begun"));
}

async function open({ id, address }: ToWorker & { kind: "open" }): Promise<void> {
  const heard = (words: string | Uint8Array<ArrayBuffer> | undefined) => {
    if (typeof words === "string") tell({ kind: "heard", id, words });
    else if (words !== undefined) tell({ kind: "heard", id, words: words.buffer }, [words.buffer]);
    else {
      sockets.delete(id);
      tell({ kind: "closed", id });
    }
  };
  try {
    sockets.set(id, (await ready()).open(address, heard));
    tell({ kind: "opened", id });
  } catch {
    tell({ kind: "closed", id });
  }
}

async function begin(base: string): Promise<void> {
  const loaded = load(base);
  studio = loaded.then(([, made]) => made);
  // Each who asks is told by itself.
  studio.catch(() => undefined);
  try {
    await loaded;
    tell({ kind: "ready" });
  } catch (cause) {
    const unfetched = cause instanceof UnfetchedError;
    tell({ kind: "broken", unfetched, reason: cause instanceof Error ? cause.message : String(cause) });
  }
}

/** One after another: what is said on a socket does not overtake its opening. */
let opening: Promise<void> = Promise.resolve();

scope.addEventListener("message", ({ data }) => {
  switch (data.kind) {
    case "begin":
      void begin(data.base);
      break;
    case "fetch":
      void answer(data);
      break;
    case "open":
      opening = opening.then(() => open(data));
      break;
    case "say":
      opening = opening.then(() => sockets.get(data.id)?.say(data.words));
      break;
    case "close":
      opening = opening.then(() => {
        sockets.get(data.id)?.close();
        sockets.delete(data.id);
      });
      break;
  }
});
