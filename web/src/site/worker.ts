/**
 * The worker of a static site: Pyodide with the same Python in it that `kitrobot` serves, called instead of asked over a network.
 *
 * The folder of missions lies in the browser's storage and is written after each request that may have changed something; a
 * save is answered once it is kept. One worker at a time has it (`open`).
 *
 * Left to others: fetching (`fetching`, `words`), starting Python (`python`, `memory`), the storage (`kept`).
 */
import { homeOf } from "../api/home";
import { Fetching, UnfetchedError } from "./fetching";
import { Kept } from "./kept";
import { forgetMemory, KeptMemory, type Memory } from "./memory";
import type { FromWorker, ToWorker } from "./messages";
import { startPython } from "./python";
import { Words } from "./words";

interface Socket {
  say: (words: string | Uint8Array<ArrayBuffer>) => void;
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

/** What is used of Emscripten's file system. */
interface Files {
  writeFile: (path: string, bytes: Uint8Array) => void;
}

type Beginning = ToWorker & { kind: "begin" };

/** What is imported before the folder of missions is there. */
const MODULES = "kitrobot.server.in_worker";
/** Requests that only ask, though they are no GET. */
const ASKS =
  /^\/api\/(again|board-file|check|fragment|image|mission\/(difference|read|team|text)|run-stretch|text|tree|exercise|walk)/;

const scope = self as unknown as {
  postMessage: (message: FromWorker, transfer?: Transferable[]) => void;
  addEventListener: (type: "message", heard: (event: MessageEvent<ToWorker>) => void) => void;
};
const tell = (message: FromWorker, transfer: Transferable[] = []) => scope.postMessage(message, transfer);

async function load({ base, parts, unpacker, pupil }: Beginning): Promise<Studio> {
  const fetching = new Fetching(base, parts, unpacker, (fetched, total) => tell({ kind: "progress", fetched, total }));
  fetching.answerPyodide();
  const started = () => tell({ kind: "starting" });
  void fetching.bytes(parts.packages).then(started, () => undefined);
  const home = homeOf(base, pupil);
  const folders = { HOME: home, KITROBOT_CONFIG: `${home}/.config/kitrobot`, KITROBOT_STATE: `${home}/state` };
  const env = { ...folders, KITROBOT_SITE: base, KITROBOT_COMPILE: "no", PYTHONDONTWRITEBYTECODE: "1" };
  const kept = new KeptMemory(base, parts.version);
  const enter = async (memory: Memory | null) => {
    try {
      const started = await startPython(base, parts, fetching, env, MODULES, memory);
      // Before Python does more: what is kept is given back then, a third of what a run would have beside it.
      if (started.memory !== null) await kept.keep(started.memory);
      keep = new Kept(started.pyodide, home, tell, () => forgetMemory(base));
      const files = started.pyodide.FS as unknown as Files;
      words = new Words(base, parts.words, (name, bytes) => files.writeFile(`${parts.place}/${name}`, bytes));
      await keep.read();
      const { begin_here } = started.pyodide.pyimport(MODULES) as {
        begin_here: (folder: string, inClass: boolean) => Promise<Studio>;
      };
      const begun = await begin_here(`${home}/missions`, pupil !== "");
      fetching.end();
      return begun;
    } catch (cause) {
      throw fetching.missing ?? cause;
    }
  };
  const memory = await kept.find();
  if (memory !== null) {
    try {
      return await enter(memory);
    } catch (cause) {
      if (cause instanceof UnfetchedError) throw cause;
      console.warn("read again, because the memory cannot be used:", cause);
      await forgetMemory(base);
    }
  }
  return enter(null);
}

let keep: Kept | null = null;
let words: Words | null = null;
const sockets = new Map<number, Socket>();
let studio: Promise<Studio> | null = null;

async function answer(message: ToWorker & { kind: "fetch" }): Promise<void> {
  const { id, method, address, headers, body } = message;
  try {
    const bytes = typeof body === "string" ? new TextEncoder().encode(body) : new Uint8Array(body ?? []);
    const python = await ready();
    await words?.have(headers["Accept-Language"] ?? "");
    const [status, told, made] = await python.fetch(method, address, headers, bytes);
    if (method === "PUT") await keep?.write();
    else if (method !== "GET" && !ASKS.test(address)) void keep?.write();
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
    const python = await ready();
    await words?.have(new URL(address, "http://python/").searchParams.get("language") ?? "");
    sockets.set(id, python.open(address, heard));
    tell({ kind: "opened", id });
  } catch {
    tell({ kind: "closed", id });
  }
}

async function begin(beginning: Beginning): Promise<void> {
  studio = load(beginning);
  // Each who asks is told by itself.
  studio.catch(() => undefined);
  try {
    await studio;
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
      void begin(data);
      break;
    case "fetch":
      void answer(data);
      break;
    case "open":
      opening = opening.then(() => open(data));
      break;
    case "say":
      opening = opening.then(() => {
        const { id, words } = data;
        sockets.get(id)?.say(typeof words === "string" ? words : new Uint8Array(words));
      });
      break;
    case "close":
      opening = opening.then(() => {
        sockets.get(data.id)?.close();
        sockets.delete(data.id);
      });
      break;
  }
});
