import { beforeEach, describe, expect, it } from "vitest";

import type { StartedMessage } from "../api/generated";
import type { AgentReport, RunMessage } from "../api/wire";
import { renderHook } from "../testing/hooks";
import { clearFrames, posesAt, pushFrame } from "./poses";
import { applyMessage, can, canGoBack, useActiveVertices, useRun, watchedAgent } from "./run";

const report = (active: [number, string][], inputs: Record<string, number> = {}): AgentReport => ({
  active,
  state: "running",
  values: {},
  inputs,
  fault: 0,
  forced: [],
  shown: {},
});

const agent = (name: string, program: string, number: number) => ({
  name,
  program,
  robot: "r",
  number,
  kind: "r",
  placed: true,
});

const STARTED: StartedMessage = {
  type: "started",
  run: "1",
  tick_ms: 20,
  seed: 3,
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
  agents: [agent("c-1", "carrier", 1), agent("c-2", "carrier", 2), agent("l", "loader", 3)],
  stock: { A: 12 },
  total: 12,
  abilities: ["fail", "force", "seek", "set", "step"],
  recording: false,
  fail_rate: 0,
  fleet: false,
  watching: false,
  another: false,
  pens: [],
};

function tick(agents: Record<string, AgentReport>, at = 1): RunMessage {
  return {
    type: "tick",
    team: null,
    drawing: null,
    tick: at,
    latest: at,
    again: false,
    seconds: at * 0.02,
    agents,
    stock: { A: 11 },
    delivered: {},
    collisions: 0,
    events: [{ tick: at, kind: "load", agent: "l", text: "", cause: "program" }],
  };
}

function hear(message: RunMessage): void {
  useRun.setState((state) => applyMessage(state, message));
}

beforeEach(() => {
  useRun.getState().reset();
});

describe("a run", () => {
  it("begins with what the server says of it", () => {
    hear(STARTED);
    const { status, agents, stock, total, seed } = useRun.getState();
    expect([status, agents.length, stock, total, seed]).toEqual(["running", 3, { A: 12 }, 12, 3]);
  });

  it("keeps agents that a tick does not speak of", () => {
    hear(STARTED);
    hear(tick({ "c-1": report([[0, "v1"]]) }));
    hear(tick({ l: report([[0, "v2"]]) }, 2));
    expect(useRun.getState().agents.map((one) => one.active)).toEqual([[[0, "v1"]], [], [[0, "v2"]]]);
  });

  it("keeps the identity of active vertices that did not change", () => {
    hear(STARTED);
    hear(tick({ "c-1": report([[0, "v1"]]) }));
    const before = useRun.getState().agents[0]?.active;
    hear(tick({ "c-1": report([[0, "v1"]], { Sign: 4 }) }, 2));
    expect(useRun.getState().agents[0]?.active).toBe(before);
    expect(useRun.getState().agents[0]?.inputs).toEqual({ Sign: 4 });
  });

  it("collects its events", () => {
    hear(STARTED);
    hear(tick({}, 1));
    hear(tick({}, 2));
    expect(useRun.getState().events.map((event) => event.tick)).toEqual([1, 2]);
  });

  it("ends with a sentence", () => {
    hear(STARTED);
    hear({ type: "state", status: "done", tick: 9, seconds: 0.18, sentence: "B holds all.", hits: [], problems: [] });
    expect([useRun.getState().status, useRun.getState().sentence]).toEqual(["done", "B holds all."]);
  });

  it("that cannot start gives the problems and is idle", () => {
    useRun.setState({ status: "connecting" });
    hear({ type: "problems", problems: [] });
    expect(useRun.getState().status).toBe("idle");
  });

  it("that the server breaks off is stopped with its words", () => {
    hear(STARTED);
    hear({ type: "error", message: "Not that.", help: "", ended: false });
    expect(useRun.getState().status).toBe("running");
    hear({ type: "error", message: "No.", help: "Yes.", ended: true });
    expect([useRun.getState().status, useRun.getState().error]).toEqual(["stopped", { message: "No.", help: "Yes." }]);
  });
});

describe("a run in its past", () => {
  const at = (tick: number, latest: number, more: Partial<RunMessage> = {}) =>
    ({ ...tick_(tick), latest, ...more }) as RunMessage;
  const tick_ = (number: number) => tick({}, number);

  it("keeps what happened until another future begins", () => {
    hear(STARTED);
    hear(at(1, 1));
    hear(at(2, 2));
    hear(at(1, 2, { events: [] }));
    expect([useRun.getState().tick, useRun.getState().latest]).toEqual([1, 2]);
    expect(useRun.getState().events.map((event) => event.tick)).toEqual([1, 2]);
    hear(at(1, 1, { again: true, events: [{ tick: 1, kind: "load", agent: "l", text: "", cause: "program" }] }));
    expect([useRun.getState().latest, useRun.getState().events.length]).toEqual([1, 1]);
  });

  it("says why it pauses", () => {
    hear(STARTED);
    const hits = [{ program: "carrier", vertex: "v1", agent: "c-1", visit: 2 }];
    hear({ type: "state", status: "paused", tick: 3, seconds: 0.06, sentence: "", hits, problems: [] });
    expect(useRun.getState().hits).toEqual(hits);
  });

  it("can be gone back in while it is on or stands at its end", () => {
    const yes = ["running", "paused", "done", "failed", "stuck", "time"] as const;
    expect(yes.every(canGoBack)).toBe(true);
    expect((["idle", "connecting", "stopped"] as const).some(canGoBack)).toBe(false);
  });
});

describe("a run that another page steers", () => {
  const WATCHED: StartedMessage = { ...STARTED, abilities: [], watching: true, another: true, fail_rate: 0.1 };

  it("is watched: it shows everything, and nothing can be done to it", () => {
    hear(WATCHED);
    hear({ type: "state", status: "paused", tick: 3, seconds: 0.06, sentence: "", hits: [], problems: [] });
    const run = useRun.getState();
    expect([run.watching, run.another, run.status, run.seed, run.failRate]).toEqual([true, true, "paused", 3, 0.1]);
    expect(can("force", run)).toBe(false);
    hear(STARTED);
    expect([useRun.getState().watching, can("force", useRun.getState())]).toEqual([false, true]);
  });

  it("is left with STOP, which shows the mission's own world again", () => {
    hear(WATCHED);
    useRun.getState().stop();
    const { watching, status, agents } = useRun.getState();
    expect([watching, status, agents]).toEqual([false, "idle", []]);
  });

  it("is over when the page that steers is gone", () => {
    hear(WATCHED);
    hear({ type: "error", message: "Gone.", help: "", ended: true });
    const { watching, status, error } = useRun.getState();
    expect([watching, status, error?.message]).toEqual([false, "stopped", "Gone."]);
  });
});

describe("a run of real robots", () => {
  const REAL: StartedMessage = {
    ...STARTED,
    agents: STARTED.agents.map((one) => ({ ...one, placed: false })),
    abilities: ["force", "seek", "set", "step"],
  };

  it("is steered as far as robots can be, also when they stand still", () => {
    useRun.setState({ seed: 5 });
    hear(REAL);
    expect([useRun.getState().real, useRun.getState().seed]).toEqual([true, 5]);
    expect((["force", "seek", "fail"] as const).map((one) => can(one, useRun.getState()))).toEqual([true, true, false]);
    hear({ type: "state", status: "stopped", tick: 3, seconds: 0.06, sentence: "", hits: [], problems: [] });
    expect(can("seek", useRun.getState())).toBe(true);
  });

  it("is not meant by a recording of them", () => {
    hear({ ...REAL, recording: true, abilities: ["seek", "step"] });
    expect(useRun.getState().real).toBe(false);
  });
});

describe("the watched agent", () => {
  it("is the first one of the program until another is chosen", () => {
    hear(STARTED);
    expect(watchedAgent(useRun.getState(), "carrier")?.name).toBe("c-1");
    useRun.getState().selectAgent("c-2");
    expect(watchedAgent(useRun.getState(), "carrier")?.name).toBe("c-2");
    expect(watchedAgent(useRun.getState(), "loader")?.name).toBe("l");
    expect(watchedAgent(useRun.getState(), "nobody")).toBeUndefined();
  });

  it("decides which vertices are active", () => {
    hear(STARTED);
    hear(
      tick({
        "c-1": report([[0, "a"]]),
        "c-2": report([
          [0, "b"],
          [1, "b"],
          [2, "c"],
        ]),
      }),
    );
    const hook = renderHook(() => useActiveVertices("carrier"));
    expect(hook.value()).toEqual(new Map([["a", [0]]]));
    hook.act(() => useRun.getState().selectAgent("c-2"));
    expect(hook.value()).toEqual(
      new Map([
        ["b", [0, 1]],
        ["c", [2]],
      ]),
    );
    hook.end();
  });

  it("gives the same map while the same vertices are active", () => {
    hear(STARTED);
    hear(tick({ "c-1": report([[0, "a"]]) }));
    const hook = renderHook(() => useActiveVertices("carrier"));
    const before = hook.value();
    hook.act(() => hear(tick({ "c-1": report([[0, "a"]]) }, 2)));
    expect(hook.value()).toBe(before);
    hook.end();
  });
});

describe("poses", () => {
  const frame = (at: number, x: number, heading = 0) => ({
    tick: at,
    poses: [{ x_mm: x, y_mm: 0, heading_rad: heading, load: 0, flags: 0 }],
  });
  beforeEach(clearFrames);

  it("are none before the first frame", () => {
    expect(posesAt(0, true)).toBeNull();
  });

  it("move from the last frame but one to the last", () => {
    pushFrame(frame(1, 0), 0);
    pushFrame(frame(2, 30), 30);
    expect(posesAt(30, true)?.poses[0]?.x_mm).toBe(0);
    expect(posesAt(45, true)).toMatchObject({ poses: [{ x_mm: 15 }], still: false });
    expect(posesAt(60, true)).toMatchObject({ poses: [{ x_mm: 30 }], still: true });
  });

  it("turn the short way round", () => {
    pushFrame(frame(1, 0, 3), 0);
    pushFrame(frame(2, 0, -3), 30);
    expect(Math.abs(posesAt(45, true)?.poses[0]?.heading_rad ?? 0)).toBeCloseTo(Math.PI, 2);
  });

  it("stand where the last frame says when motion is not wanted", () => {
    pushFrame(frame(1, 0), 0);
    pushFrame(frame(2, 30), 30);
    expect(posesAt(31, false)).toMatchObject({ poses: [{ x_mm: 30 }], still: true });
  });

  it("jump when they are far apart", () => {
    pushFrame(frame(1, 0), 0);
    pushFrame(frame(2, 5000), 30);
    expect(posesAt(40, true)?.poses[0]?.x_mm).toBe(5000);
  });

  it("do not run backwards into an earlier run", () => {
    pushFrame(frame(100, 0), 0);
    pushFrame(frame(1, 30), 30);
    expect(posesAt(31, true)?.still).toBe(true);
  });
});
