/**
 * Python's memory once its modules are read, kept in the browser: a later visit goes on from it and reads none of them.
 *
 * It fits only the files and the browser that it was made with, and holds nothing of a person's: it is taken before the folder
 * of missions is there. It may be thrown away at any time; then modules are read again.
 */
export interface Memory {
  bytes: Uint8Array<ArrayBuffer>;
  /** How many functions the browser's table had: another number means that the memory does not fit. */
  table: number;
}

const TABLE = "X-Table";
const LENGTH = "X-Length";
/** It takes at most this share of what the browser would still keep. */
const SHARE = 0.25;
const PIECE = 1_000_000;

/** The name of its place among the browser's caches. */
const placeOf = (base: string) => `kitrobot memory ${base}`;

/** Throws away what is kept; whether there was something. */
export async function forgetMemory(base: string): Promise<boolean> {
  // Pages of unsafe addresses have no caches.
  return "caches" in self && (await caches.delete(placeOf(base)).catch(() => false));
}

export class KeptMemory {
  readonly #base: string;
  readonly #address: URL;

  /** `version`: of the files. */
  constructor(base: string, version: string) {
    this.#base = base;
    this.#address = new URL("python-memory", base);
    const fits = [version, navigator.userAgent, navigator.language];
    this.#address.search = String(new URLSearchParams(fits.map((value, at) => [String(at), value])));
  }

  async find(): Promise<Memory | null> {
    if (!("caches" in self)) return null;
    try {
      const found = await (await caches.open(placeOf(this.#base))).match(this.#address);
      if (found === undefined) return null;
      const bytes = new Uint8Array(await found.arrayBuffer());
      const whole = bytes.length === Number(found.headers.get(LENGTH));
      return whole ? { bytes, table: Number(found.headers.get(TABLE)) } : null;
    } catch {
      return null;
    }
  }

  /** Keeps it in the place of others, if there is much room, and gives back its bytes; that it cannot be kept is no fault. */
  async keep({ bytes, table }: Memory): Promise<void> {
    try {
      if (!("caches" in self)) return;
      await forgetMemory(this.#base);
      const { quota = 0, usage = 0 } = await navigator.storage.estimate();
      if (bytes.length > SHARE * (quota - usage)) return;
      const headers = { [TABLE]: String(table), [LENGTH]: String(bytes.length) };
      await (await caches.open(placeOf(this.#base))).put(this.#address, new Response(inPieces(bytes), { headers }));
    } catch {
      await forgetMemory(this.#base);
    } finally {
      giveBack(bytes);
    }
  }
}

/** Piece by piece: a response has a copy of its own of what it is made of, until the browser looks for garbage. */
function inPieces(bytes: Uint8Array<ArrayBuffer>): ReadableStream<Uint8Array<ArrayBuffer>> {
  let at = 0;
  return new ReadableStream({
    pull(controller) {
      if (at < bytes.length) controller.enqueue(bytes.slice(at, at + PIECE));
      else controller.close();
      at += PIECE;
    },
  });
}

/** At once, where the browser can: it looks for garbage seldom where there is much room. The bytes are empty then. */
export function giveBack({ buffer }: Uint8Array<ArrayBuffer>): void {
  (buffer as { transfer?: (length: number) => unknown }).transfer?.(0);
}
