import { afterEach, beforeEach, expect, it, vi } from "vitest";

import type { StartedMessage } from "../api/generated";
import { setTransport, transport } from "../api/transport";
import { useStudio } from "../model/studio";
import type { Breakpoint } from "../model/types";
import { followBreakpoints } from "./breakpoints";
import { useRun } from "./run";

const STARTED: StartedMessage = {
  type: "started",
  run: "1",
  tick_ms: 20,
  seed: 1,
  agents: [],
  world: {
    name: "",
    width_mm: 1,
    height_mm: 1,
    walls: [],
    floors: [],
    lines: [],
    roads: [],
    docks: [],
    storehouses: [],
    starts: [],
  },
  stock: {},
  total: 0,
  abilities: ["seek"],
  recording: false,
  fleet: false,
  fail_rate: 0,
  watching: false,
  another: false,
  pens: [],
};

/** The studio's end of a run's socket: what the page said, and what is answered. */
class OtherEnd extends EventTarget {
  readyState: number = WebSocket.CONNECTING;
  binaryType = "";
  readonly said: unknown[] = [];

  send(text: string): void {
    this.said.push(JSON.parse(text));
  }

  close(): void {
    this.readyState = WebSocket.CLOSED;
  }

  open(): void {
    this.readyState = WebSocket.OPEN;
    this.dispatchEvent(new Event("open"));
  }

  tell(message: object): void {
    this.dispatchEvent(new MessageEvent("message", { data: JSON.stringify(message) }));
  }
}

const usual = transport();
let ends: OtherEnd[] = [];
let off = (): void => undefined;

beforeEach(() => {
  ends = [];
  vi.stubGlobal("requestAnimationFrame", (picture: FrameRequestCallback) => picture(0));
  setTransport({
    ...usual,
    socket: () => {
      const end = new OtherEnd();
      ends.push(end);
      return end as unknown as WebSocket;
    },
  });
  useRun.getState().reset();
  setBreakpoints([]);
  off = followBreakpoints(() => undefined);
});

afterEach(() => {
  off();
  useRun.getState().reset();
  setTransport(usual);
  vi.unstubAllGlobals();
});

const mission = () => useStudio.getState().mission;
const BREAKPOINTS: Breakpoint[] = [{ program: "carrier", vertex: "v1" }];

function setBreakpoints(breakpoints: Breakpoint[]): void {
  useStudio.setState({ mission: { ...mission(), breakpoints } });
}

it.each(["before the socket is open", "before the run is ready"])(
  "a breakpoint that is set %s is told as soon as the run has begun",
  (when) => {
    useRun.getState().start({ mission: mission(), path: "" });
    const [end] = ends;
    if (end === undefined) throw new Error("no socket");
    if (when === "before the socket is open") setBreakpoints(BREAKPOINTS);
    end.open();
    if (when === "before the run is ready") setBreakpoints(BREAKPOINTS);
    expect(end.said.map((one) => (one as { type: string }).type)).toEqual(["start"]);
    end.tell(STARTED);
    expect(end.said.slice(1)).toEqual([{ type: "breakpoints", breakpoints: BREAKPOINTS }]);
  },
);

it("what was asked of a run that never began is not asked of the next", () => {
  useRun.getState().start({ mission: mission(), path: "" });
  useRun.getState().setSpeed(4);
  useRun.getState().start({ mission: mission(), path: "" });
  const [, end] = ends;
  end?.open();
  end?.tell(STARTED);
  expect(end?.said).toHaveLength(1);
});

it("a run that another page steers is asked nothing", () => {
  useRun.getState().watch({ mission: mission(), run: "1" });
  setBreakpoints(BREAKPOINTS);
  const [end] = ends;
  end?.open();
  end?.tell({ ...STARTED, watching: true });
  expect(end?.said).toHaveLength(1);
});
