/**
 * Serial ports of this computer that the reader has let the page use (Web Serial): for each a socket of its own to the server,
 * which uses it as it uses a port of its own. The page only passes bytes on, both ways.
 *
 * The server says when a port is opened and closed, so other programs may have it meanwhile. A port that was unplugged is
 * offered again, at the same address, when it comes back.
 */
import { create } from "zustand";

import { socketAddress } from "../../api/address";
import { transport } from "../../api/transport";
import { joinBytes } from "../../model/bytes";
import { useBoards } from "./boards";

/** What is used of a `SerialPort`; TypeScript does not know Web Serial. */
export interface Port extends EventTarget {
  readonly readable: ReadableStream<Uint8Array<ArrayBuffer>> | null;
  readonly writable: WritableStream<Uint8Array<ArrayBuffer>> | null;
  getInfo: () => { usbVendorId?: number };
  open: (options: { baudRate: number; bufferSize: number }) => Promise<void>;
  close: () => Promise<void>;
  setSignals: (signals: { requestToSend?: boolean; dataTerminalReady?: boolean }) => Promise<void>;
}

interface Serial extends EventTarget {
  requestPort: () => Promise<Port>;
}

const BAUD = 115200;
const BUFFER_BYTES = 16 * 1024;
/** Bytes that may wait on their way to the server; the board is not read until there are fewer. */
const MOST_WAITING = 64 * 1024;
/** Bytes in one message. */
const MOST_PIECE = 32 * 1024;
const LOOK_MS = 10;

/** Whether the page can reach boards: it can, the address is not safe enough for it, or the browser cannot. */
export type Reach = "there" | "unsafe" | "none";

const serial = (): Serial | undefined => (navigator as { serial?: Serial }).serial;

export function reachOf(there: boolean, secure: boolean): Reach {
  return there ? "there" : secure ? "none" : "unsafe";
}

export const reach = (): Reach => reachOf(serial() !== undefined, window.isSecureContext);

/** One port and its socket; it ends when either does. */
export class Pipe {
  readonly #port: Port;
  readonly #socket: WebSocket;
  /** Opening and closing, one after the other. */
  #turn: Promise<void> = Promise.resolve();
  #reader: ReadableStreamDefaultReader<Uint8Array<ArrayBuffer>> | null = null;
  #writer: WritableStreamDefaultWriter<Uint8Array<ArrayBuffer>> | null = null;
  #reading: Promise<void> = Promise.resolve();
  #came: Uint8Array<ArrayBuffer>[] = [];
  readonly #soon = new MessageChannel();

  constructor(port: Port, socket: WebSocket, ended: () => void) {
    this.#port = port;
    this.#socket = socket;
    socket.binaryType = "arraybuffer";
    this.#soon.port1.onmessage = () => this.#passOn();
    socket.addEventListener("message", ({ data }: MessageEvent<string | ArrayBuffer>) => {
      if (typeof data !== "string") this.#write(new Uint8Array(data));
      else if (data === "open") this.#turn = this.#turn.then(() => this.#open());
      else if (data === "close") this.#turn = this.#turn.then(() => this.#close());
    });
    socket.addEventListener("close", () => {
      this.#soon.port1.close();
      this.#turn = this.#turn.then(() => this.#close()).then(ended);
    });
  }

  /** The cable is out, or the page goes to sleep: what comes later is not for this board any more. */
  gone(): void {
    this.#say("gone");
    this.#socket.close();
  }

  #say(word: string | Uint8Array<ArrayBuffer>): void {
    if (this.#socket.readyState === WebSocket.OPEN) this.#socket.send(word);
  }

  async #open(): Promise<void> {
    try {
      await this.#port.open({ baudRate: BAUD, bufferSize: BUFFER_BYTES });
    } catch (cause) {
      const name = cause instanceof DOMException ? cause.name : "";
      this.#say(name === "NetworkError" || name === "InvalidStateError" ? "busy" : "failed");
      return;
    }
    this.#writer = this.#port.writable?.getWriter() ?? null;
    this.#say("opened");
    this.#reading = this.#read();
  }

  async #read(): Promise<void> {
    // After an error that is no end (a byte that was overrun) there is another stream.
    while (this.#writer !== null && this.#port.readable !== null) {
      const reader = this.#port.readable.getReader();
      this.#reader = reader;
      try {
        for (;;) {
          const { value, done } = await reader.read();
          if (done) return;
          await this.#pass(value);
        }
      } catch {
        if (this.#port.readable === null) this.gone();
      } finally {
        this.#reader = null;
        reader.releaseLock();
      }
    }
  }

  async #pass(data: Uint8Array<ArrayBuffer>): Promise<void> {
    // A board sends byte by byte: what has come by the next turn of the page goes in one message.
    if (this.#came.length === 0) this.#soon.port2.postMessage(null);
    this.#came.push(data);
    while (this.#socket.bufferedAmount > MOST_WAITING && this.#socket.readyState === WebSocket.OPEN) {
      await new Promise((resolve) => setTimeout(resolve, LOOK_MS));
    }
  }

  #passOn(): void {
    const came = joinBytes(this.#came);
    this.#came = [];
    for (let at = 0; at < came.length; at += MOST_PIECE) this.#say(came.subarray(at, at + MOST_PIECE));
  }

  #write(data: Uint8Array<ArrayBuffer>): void {
    // Of one that is not open nothing is wanted.
    this.#writer?.write(data).catch(() => {
      if (this.#port.writable === null) this.gone();
    });
  }

  async #close(): Promise<void> {
    const writer = this.#writer;
    if (writer === null) return;
    this.#writer = null;
    const quietly = (work: Promise<unknown> | undefined) => work?.catch(() => undefined);
    await quietly(this.#reader?.cancel());
    await this.#reading;
    // What was said last is still on its way, as the word to stop; a board that takes nothing is not waited for.
    await Promise.race([quietly(writer.close()), new Promise((resolve) => setTimeout(resolve, 1000))]);
    await quietly(writer.abort());
    writer.releaseLock();
    // In this order a board whose reset hangs on these two wires is not reset.
    await quietly(this.#port.setSignals({ requestToSend: false }));
    await quietly(this.#port.setSignals({ dataTerminalReady: false }));
    await quietly(this.#port.close());
  }
}

interface Held {
  mark: string;
  pipe: Pipe | null;
}

const held = new Map<Port, Held>();

/** Addresses of what this page holds; the server has the same ones in its list. */
export const useSerial = create<{ marks: string[] }>(() => ({ marks: [] }));

const tell = () => useSerial.setState({ marks: [...held.values()].map(({ mark }) => mark) });

function newMark(): string {
  return crypto.randomUUID().replaceAll("-", "");
}

function offer(port: Port): void {
  const entry = held.get(port);
  const { key } = useBoards.getState();
  if (entry === undefined || entry.pipe !== null || key === "") return;
  const address = socketAddress("api/boards/port");
  address.searchParams.set("key", key);
  address.searchParams.set("mark", entry.mark);
  address.searchParams.set("vendor", String(port.getInfo().usbVendorId ?? 0));
  const pipe = new Pipe(port, transport().socket(address), () => {
    if (held.get(port)?.pipe === pipe) held.set(port, { ...entry, pipe: null });
  });
  held.set(port, { ...entry, pipe });
}

let heard = false;

function hearOfCables(found: Serial): void {
  if (heard) return;
  heard = true;
  found.addEventListener("disconnect", ({ target }) => held.get(target as Port)?.pipe?.gone());
  found.addEventListener("connect", ({ target }) => offer(target as Port));
  // A page that sleeps would say late what the robot was to do long ago.
  document.addEventListener("freeze", () => {
    for (const { pipe } of held.values()) pipe?.gone();
  });
  useBoards.subscribe(({ key }, before) => {
    if (key === before.key) return;
    for (const [port, { pipe }] of held) {
      if (key === "") pipe?.gone();
      // The old server, or none: the new one is told of it under another name.
      else held.set(port, { mark: newMark(), pipe: null });
      offer(port);
    }
    tell();
  });
}

/** Lets the reader choose a board; nothing happens when nothing is chosen. */
export async function findBoard(): Promise<void> {
  const found = serial();
  if (found === undefined) return;
  hearOfCables(found);
  let port: Port;
  try {
    port = await found.requestPort();
  } catch {
    return;
  }
  if (!held.has(port)) held.set(port, { mark: newMark(), pipe: null });
  offer(port);
  tell();
}

/** The board is in the list no more. */
export function dropBoard(address: string): void {
  for (const [port, { mark, pipe }] of held) {
    if (!address.endsWith(`:${mark}`)) continue;
    held.delete(port);
    pipe?.gone();
  }
  tell();
}
