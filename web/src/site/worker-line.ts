/**
 * Requests and sockets as messages to the worker. They look to the page as those of the network do, as far as it uses them.
 *
 * Left to others: when the worker begins (`open`), what it answers (`worker`).
 */
import type { Transport } from "../api/transport";
import type { FromWorker, ToWorker } from "./messages";

type Post = (message: ToWorker, transfer?: Transferable[]) => void;

/** Answers that have no body, not even an empty one. */
const BODILESS = [204, 205, 304];

type Say = (words: string | ArrayBuffer) => void;

class PageSocket extends EventTarget {
  binaryType = "arraybuffer";
  /** The worker takes what it is told. */
  readonly bufferedAmount = 0;
  readyState: number = WebSocket.CONNECTING;
  readonly #say: Say;
  readonly #hangUp: () => void;

  constructor(say: Say, hangUp: () => void) {
    super();
    this.#say = say;
    this.#hangUp = hangUp;
  }

  send(words: string | Uint8Array<ArrayBuffer>): void {
    if (this.readyState !== WebSocket.OPEN) return;
    // A copy, which the worker may have: the caller keeps its own, as with a network.
    this.#say(typeof words === "string" ? words : words.slice().buffer);
  }

  close(): void {
    if (this.readyState >= WebSocket.CLOSING) return;
    this.#hangUp();
    this.ended();
  }

  opened(): void {
    if (this.readyState !== WebSocket.CONNECTING) return;
    this.readyState = WebSocket.OPEN;
    this.dispatchEvent(new Event("open"));
  }

  heard(words: string | ArrayBuffer): void {
    if (this.readyState === WebSocket.OPEN) this.dispatchEvent(new MessageEvent("message", { data: words }));
  }

  ended(): void {
    if (this.readyState === WebSocket.CLOSED) return;
    this.readyState = WebSocket.CLOSED;
    this.dispatchEvent(new CloseEvent("close"));
  }
}

interface Waiting {
  resolve: (response: Response) => void;
  reject: (cause: unknown) => void;
}

export class WorkerLine implements Transport {
  readonly #post: Post;
  readonly #base: string;
  readonly #asked = new Map<number, Waiting>();
  readonly #sockets = new Map<number, PageSocket>();
  #last = 0;

  /** `base`: the path that the page is under, with a slash at its end. */
  constructor(post: Post, base: string) {
    this.#post = post;
    this.#base = base;
  }

  fetch = (address: string, { method = "GET", headers, body, signal }: RequestInit): Promise<Response> => {
    this.#last += 1;
    const id = this.#last;
    return new Promise((resolve, reject) => {
      const giveUp = () => {
        this.#asked.delete(id);
        reject(new DOMException("nobody waits for it", "AbortError"));
      };
      if (signal?.aborted) {
        giveUp();
        return;
      }
      signal?.addEventListener("abort", giveUp);
      this.#asked.set(id, { resolve, reject });
      const sent = body instanceof ArrayBuffer || typeof body === "string" ? body : null;
      const said = headers as Record<string, string>;
      this.#post({ kind: "fetch", id, method, address: `/${address}`, headers: said, body: sent });
    });
  };

  socket = ({ pathname, search }: URL): WebSocket => {
    this.#last += 1;
    const id = this.#last;
    const hangUp = () => {
      this.#sockets.delete(id);
      this.#post({ kind: "close", id });
    };
    const made = new PageSocket((words) => {
      this.#post({ kind: "say", id, words }, typeof words === "string" ? [] : [words]);
    }, hangUp);
    this.#sockets.set(id, made);
    this.#post({ kind: "open", id, address: `/${pathname.slice(this.#base.length)}${search}` });
    return made as unknown as WebSocket;
  };

  /** What the worker said; false where it is none of ours. */
  hear(message: FromWorker): boolean {
    switch (message.kind) {
      case "answer": {
        const { status, headers, body } = message;
        this.#take(message.id)?.resolve(new Response(BODILESS.includes(status) ? null : body, { status, headers }));
        return true;
      }
      case "failed":
        this.#take(message.id)?.reject(new TypeError(message.reason));
        return true;
      case "opened":
        this.#sockets.get(message.id)?.opened();
        return true;
      case "heard":
        this.#sockets.get(message.id)?.heard(message.words);
        return true;
      case "closed":
        this.#sockets.get(message.id)?.ended();
        this.#sockets.delete(message.id);
        return true;
      default:
        return false;
    }
  }

  #take(id: number): Waiting | undefined {
    const waiting = this.#asked.get(id);
    this.#asked.delete(id);
    return waiting;
  }
}
