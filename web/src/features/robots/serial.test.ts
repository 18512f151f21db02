import { describe, expect, it, vi } from "vitest";

import { setTransport, transport } from "../../api/transport";
import { joinBytes } from "../../model/bytes";
import { useBoards } from "./boards";
import { findBoard, Pipe, type Port, reachOf, useSerial } from "./serial";

describe("whether a page reaches boards", () => {
  it("says what is in the way", () => {
    expect(reachOf(true, true)).toBe("there");
    expect(reachOf(false, true)).toBe("none");
    expect(reachOf(false, false)).toBe("unsafe");
  });
});

describe("pieces of a board", () => {
  it("are one message in their order", () => {
    const pieces = [[1], [], [2, 3]].map((piece) => new Uint8Array(piece));
    expect([...joinBytes(pieces)]).toEqual([1, 2, 3]);
    expect([...joinBytes([])]).toEqual([]);
  });
});

class Socket extends EventTarget {
  binaryType = "";
  bufferedAmount = 0;
  readyState: number = WebSocket.OPEN;
  readonly said: (string | number[])[] = [];

  send(words: string | Uint8Array): void {
    this.said.push(typeof words === "string" ? words : [...words]);
  }

  close(): void {
    this.readyState = WebSocket.CLOSED;
    this.dispatchEvent(new CloseEvent("close"));
  }

  hear(data: string | ArrayBuffer): void {
    this.dispatchEvent(new MessageEvent("message", { data }));
  }
}

class Plug extends EventTarget implements Port {
  readable: Port["readable"] = null;
  writable: Port["writable"] = null;
  readonly done: string[] = [];
  refuses: DOMException | null = null;
  give: (piece: number[]) => void = () => undefined;
  lose: () => void = () => undefined;

  getInfo = () => ({});

  open = () => {
    if (this.refuses !== null) return Promise.reject(this.refuses);
    this.done.push("open");
    this.readable = new ReadableStream({
      start: (into) => {
        this.give = (piece) => into.enqueue(new Uint8Array(piece));
        this.lose = () => {
          this.readable = this.writable = null;
          into.error(new DOMException("lost", "NetworkError"));
        };
      },
    });
    this.writable = new WritableStream({ write: (data) => void this.done.push([...data].join()) });
    return Promise.resolve();
  };

  close = () => {
    this.done.push("close");
    return Promise.resolve();
  };

  setSignals = (signals: object) => {
    this.done.push(Object.keys(signals).join());
    return Promise.resolve();
  };
}

function piped() {
  const [port, socket] = [new Plug(), new Socket()];
  const ended = new Promise<void>((resolve) => new Pipe(port, socket as unknown as WebSocket, resolve));
  return { port, socket, ended };
}

const until = (holds: () => void) => expect.poll(() => (holds(), true)).toBe(true);

describe("the pipe of a port", () => {
  it("opens when it is asked to, passes bytes on, and lets the wires go in order after the last word", async () => {
    const { port, socket, ended } = piped();
    socket.hear(new Uint8Array([9]).buffer);
    socket.hear("open");
    await until(() => expect(socket.said).toEqual(["opened"]));
    port.give([1]);
    port.give([2]);
    await until(() => expect(socket.said.slice(1).flat()).toEqual([1, 2]));
    socket.hear(new Uint8Array([3]).buffer);
    socket.hear("close");
    await until(() => expect(port.done).toEqual(["open", "3", "requestToSend", "dataTerminalReady", "close"]));
    socket.close();
    await ended;
  });

  it("says which refusal of the browser it was", async () => {
    const { port, socket } = piped();
    port.refuses = new DOMException("", "NetworkError");
    socket.hear("open");
    await until(() => expect(socket.said).toEqual(["busy"]));
    port.refuses = new DOMException("", "SecurityError");
    socket.hear("open");
    await until(() => expect(socket.said).toEqual(["busy", "failed"]));
  });

  it("ends when the cable is pulled", async () => {
    const { port, socket, ended } = piped();
    socket.hear("open");
    await until(() => expect(socket.said).toEqual(["opened"]));
    port.lose();
    await ended;
    expect(socket.said).toEqual(["opened", "gone"]);
    expect(port.done.at(-1)).toBe("close");
  });
});

it("a board that was chosen is let go when the browser freezes the page, and has its place when it is chosen again", async () => {
  const usual = transport();
  const [port, sockets] = [new Plug(), [] as Socket[]];
  const asked = vi.fn(() => Promise.resolve(port));
  const found = Object.assign(new EventTarget(), { requestPort: asked });
  Object.defineProperty(navigator, "serial", { configurable: true, value: found });
  setTransport({ ...usual, socket: () => (sockets.push(new Socket()), sockets.at(-1)) as unknown as WebSocket });
  useBoards.setState({ key: "k" });
  await findBoard();
  sockets[0]?.hear("open");
  await until(() => expect(sockets[0]?.said).toEqual(["opened"]));
  const { marks } = useSerial.getState();
  document.dispatchEvent(new Event("freeze"));
  await until(() => expect(sockets[0]?.said).toEqual(["opened", "gone"]));
  sockets[0]?.close();
  await until(() => expect(port.done.at(-1)).toBe("close"));
  // It has its place again once the port is closed.
  await until(() => {
    void findBoard();
    expect(sockets).toHaveLength(2);
  });
  expect(useSerial.getState().marks).toEqual(marks);
  setTransport(usual);
  useBoards.setState(useBoards.getInitialState());
  Reflect.deleteProperty(navigator, "serial");
});
