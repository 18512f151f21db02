import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { openRunSocket, type RunSocket } from "./socket";
import { setTransport, transport } from "./transport";

/** The studio's end of a run's socket. */
class OtherEnd extends EventTarget {
  readyState: number = WebSocket.OPEN;
  binaryType = "";
  close(): void {
    this.readyState = WebSocket.CLOSED;
  }
  tell(tick: number): void {
    this.dispatchEvent(new MessageEvent("message", { data: JSON.stringify({ type: "tick", tick }) }));
  }
  /** A frame without robots. */
  show(tick: number): void {
    this.dispatchEvent(new MessageEvent("message", { data: new Float32Array([tick, 0, 0]).buffer }));
  }
  end(): void {
    this.dispatchEvent(new Event("close"));
  }
}

const usual = transport();
let pictures: FrameRequestCallback[] = [];
let end: OtherEnd;
let heard: (number | string)[] = [];
let hand: RunSocket;

function draw(): void {
  for (const picture of pictures.splice(0)) picture(0);
}

function hide(hidden: boolean): void {
  Object.defineProperty(document, "hidden", { configurable: true, value: hidden });
  document.dispatchEvent(new Event("visibilitychange"));
}

beforeEach(() => {
  [heard, pictures, end] = [[], [], new OtherEnd()];
  vi.stubGlobal("requestAnimationFrame", (picture: FrameRequestCallback) => pictures.push(picture));
  setTransport({ ...usual, socket: () => end as unknown as WebSocket });
  hand = openRunSocket({
    onOpen: () => undefined,
    onMessage: (message) => {
      if (message.type !== "tick") return;
      heard.push(message.tick);
      if (message.tick === 9) hand.close();
    },
    onFrames: (_way, last) => heard.push(`frame ${String(last.tick)}`),
    onLost: () => heard.push("lost"),
  });
});

afterEach(() => {
  hide(false);
  setTransport(usual);
  vi.unstubAllGlobals();
});

it("hands on with the next picture all that came before it, in order", () => {
  for (const tick of [1, 2, 3]) end.tell(tick);
  expect([heard, pictures.length]).toEqual([[], 1]);
  draw();
  expect(heard).toEqual([1, 2, 3]);
  end.tell(4);
  draw();
  expect(heard).toEqual([1, 2, 3, 4]);
});

it("hands frames on in their order among the messages", () => {
  end.tell(1);
  end.show(1);
  end.tell(2);
  end.show(2);
  expect(heard).toEqual([]);
  draw();
  expect(heard).toEqual([1, "frame 1", 2, "frame 2"]);
});

it("waits for no picture in a page that draws none", () => {
  end.tell(1);
  hide(true);
  expect(heard).toEqual([1]);
  end.tell(2);
  expect(heard).toEqual([1, 2]);
});

it("hands on what came before the line was lost, and nothing once the run is left", () => {
  end.tell(1);
  end.end();
  expect(heard).toEqual([1, "lost"]);
  draw();
  expect(heard).toEqual([1, "lost"]);
});

it("hands on nothing after the message at which the run was left", () => {
  for (const tick of [8, 9, 10]) end.tell(tick);
  draw();
  end.end();
  expect(heard).toEqual([8, 9]);
});
