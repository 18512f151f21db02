/**
 * The run that is on, as the page knows it: status, clock, what each agent does, stock and deliveries.
 *
 * One run at a time. Agents are in the server's order, the order of the binary pose frames too; an agent's `active` keeps
 * its identity while the same vertices are active, so that a canvas redraws only when something changed. Poses are not
 * here but in `poses.ts`. Recordings and real robots come as runs too, which differ in what can be done to them. The mission
 * that runs is the one that was given to `start`; later edits do not reach it.
 *
 * A run that another page steers can be watched: then nothing here steers it, and STOP ends the watching.
 */
import { useMemo } from "react";
import { create } from "zustand";

import { openRunSocket, type RunSocket } from "../api/socket";
import type { Ability, AgentReport, Hit, RunEvent, RunMessage, RunRequest, StartedAgent } from "../api/wire";
import { useStudio } from "../model/studio";
import type { Call } from "../model/team-names";
import type { Mission, Problem } from "../model/types";
import { forgetMarks, takeMarks } from "./pen-marks";
import { clearFrames, pushFrame } from "./poses";
import type { RunAgent, RunState, RunStatus } from "./run-state";
import { SeekQueue } from "./seek-queue";

export type { RunAgent, RunState, RunStatus } from "./run-state";

const MOST_EVENTS = 5000;

const NOTHING = {
  status: "idle" as RunStatus,
  tick: 0,
  latest: 0,
  hits: [] as Hit[],
  seconds: 0,
  tickMs: 20,
  sentence: "",
  agents: [] as RunAgent[],
  world: null,
  stock: {},
  delivered: {},
  total: 0,
  collisions: 0,
  events: [] as RunEvent[],
  team: null as RunState["team"],
  error: null,
  problems: [] as Problem[],
  mission: null as Mission | null,
  name: "",
  abilities: [] as readonly Ability[],
  recording: false,
  watching: false,
  another: false,
  real: false,
  isFleet: false,
};

let socket: RunSocket | null = null;
/** What was asked of the run before it began. */
let early: RunRequest[] = [];

function sameActive(a: RunAgent["active"], b: RunAgent["active"]): boolean {
  return a.length === b.length && a.every(([slot, vertex], i) => b[i]?.[0] === slot && b[i][1] === vertex);
}

function merge(agents: RunAgent[], reports: Record<string, AgentReport>): RunAgent[] {
  if (Object.keys(reports).length === 0) return agents;
  return agents.map((agent) => {
    const report = reports[agent.name];
    if (report === undefined) return agent;
    const active = sameActive(agent.active, report.active) ? agent.active : report.active;
    return { ...agent, ...report, active };
  });
}

function statusAfter(before: RunStatus, ended: boolean): RunStatus {
  if (before === "connecting") return "idle";
  return ended && isLive(before) ? "stopped" : before;
}

function eventsAfter(before: RunEvent[], { again, events }: { again: boolean; events: RunEvent[] }): RunEvent[] {
  if (again) return events;
  return events.length === 0 ? before : [...before, ...events].slice(-MOST_EVENTS);
}

/** Whether these are real robots: nobody knows where they are, and no seed began their run. */
export function isHardwareRun(agents: readonly StartedAgent[]): boolean {
  return agents.length > 0 && agents.every(({ placed }) => !placed);
}

/** What a message of the server changes. */
export function applyMessage(state: RunState, message: RunMessage): Partial<RunState> {
  switch (message.type) {
    case "started":
      return {
        ...NOTHING,
        mission: state.mission,
        name: String(message.run),
        abilities: message.abilities,
        recording: message.recording,
        real: !message.recording && isHardwareRun(message.agents),
        isFleet: message.fleet,
        watching: message.watching,
        another: message.another,
        failRate: message.fail_rate,
        status: "running",
        tickMs: message.tick_ms,
        seed: isHardwareRun(message.agents) ? state.seed : message.seed,
        world: message.world,
        stock: message.stock,
        total: message.total,
        agents: message.agents.map((agent) => ({
          ...agent,
          active: [],
          state: "idle",
          values: {},
          inputs: {},
          shown: {},
          used: [],
          fault: 0,
          forced: [],
        })),
      };
    case "state":
      return {
        status: message.status,
        isFleet: state.isFleet && isLive(message.status),
        tick: message.tick,
        seconds: message.seconds,
        sentence: message.sentence,
        hits: message.hits,
        problems: message.problems,
      };
    case "tick":
      return {
        tick: message.tick,
        latest: message.latest,
        seconds: message.seconds,
        agents: merge(state.agents, message.agents),
        stock: message.stock,
        delivered: message.delivered,
        collisions: message.collisions,
        events: eventsAfter(state.events, message),
        team: message.team ?? state.team,
      };
    case "problems":
      return { ...NOTHING, problems: message.problems };
    case "error":
      return {
        status: statusAfter(state.status, message.ended),
        watching: state.watching && !message.ended,
        error: { message: message.message, help: message.help },
      };
  }
}

export function isLive(status: RunStatus): boolean {
  return status === "connecting" || status === "running" || status === "paused";
}

/** Whether the run has a past that can be gone to: one that was stopped is over. */
export function canGoBack(status: RunStatus): boolean {
  return status === "running" || status === "paused" || isEnded(status);
}

/** Whether the run is there to be asked: real robots that were stopped may be started again in it. */
export function isQueryable({ status, real }: Pick<RunState, "status" | "real">): boolean {
  return canGoBack(status) || (real && status === "stopped");
}

/** Whether that can be done to the run now. */
export function can(ability: Ability, state: RunState): boolean {
  return state.abilities.includes(ability) && isQueryable(state);
}

/** Whether it stands at its end. */
export function isEnded(status: RunStatus): boolean {
  return status === "done" || status === "failed" || status === "stuck" || status === "time" || status === "end";
}

const seeks = new SeekQueue((tick) => socket?.send({ type: "seek", tick }));

/** The tick that the run is on its way to, or the one it is at. */
export function targetTick({ tick }: Pick<RunState, "tick">): number {
  return seeks.target ?? tick;
}

/** Of more agents than this the server reports only those that are looked at. */
const MANY = 100;
const MOST_LOOKED_AT = 200;

function sendLook({ agents, selectedAgent }: Pick<RunState, "agents" | "selectedAgent">): void {
  if (agents.length <= MANY) return;
  socket?.send({ type: "look", agents: Object.values(selectedAgent).slice(0, MOST_LOOKED_AT) });
}

/** Names of the runs that this page started: those that others started can be watched. */
const ours = new Set<string>();

export function isOurs(run: string): boolean {
  return ours.has(run);
}

function hangUp(): void {
  seeks.clear();
  early = [];
  socket?.close();
  socket = null;
}

/** Begins a run, plays a recording, or watches robots, in the place of what was on. */
function connect(mission: Mission, request: RunRequest): void {
  hangUp();
  clearFrames();
  forgetMarks();
  useRun.setState({ ...NOTHING, status: "connecting", mission });
  socket = openRunSocket({
    onOpen: (opened) => opened.send(request),
    onMessage: (message) => {
      takeMarks(message);
      useRun.setState((state) => applyMessage(state, message));
      if (message.type === "started") {
        if (!message.watching) ours.add(String(message.run));
        sendLook(useRun.getState());
        early.splice(0).forEach(steer);
      }
      if (message.type === "tick") seeks.answer();
      if (
        message.type === "problems" ||
        (message.type === "error" && (message.ended || !canGoBack(useRun.getState().status)))
      )
        hangUp();
    },
    onFrames: (way, last) => pushFrame(last, performance.now(), way),
    onLost: (failure) => {
      socket = null;
      const { status } = useRun.getState();
      if (isLive(status)) useRun.setState({ status: status === "connecting" ? "idle" : "stopped", error: failure });
    },
  });
}

/** Asks something of the run, once it has begun; of one that another page steers nothing is asked. */
function steer(request: RunRequest): void {
  const { status, watching } = useRun.getState();
  if (status === "connecting") early.push(request);
  else if (!watching) socket?.send(request);
}

export const useRun = create<RunState>((set, get) => ({
  ...NOTHING,
  seed: 1,
  speed: 1,
  failRate: 0,
  selectedAgent: {},

  start: ({ mission, path }, like) => {
    const { seed, speed, failRate } = get();
    connect(mission, { type: "start", mission, path, seed, speed, fail_rate: failRate, ...like });
  },
  robots: (what) => {
    const { breakpoints = [] } = useStudio.getState().mission;
    connect(what.mission, { type: "robots", speed: get().speed, breakpoints, ...what });
  },
  watch: ({ mission, run }) => connect(mission, { type: "watch", run, mission }),
  replay: ({ mission, recording, breakpoints }) =>
    connect(mission, { type: "replay", recording, speed: get().speed, breakpoints }),
  pause: () => {
    if (get().status === "running") steer({ type: "pause" });
  },
  resume: () => {
    if (get().status === "paused") steer({ type: "resume" });
  },
  follow: () => steer({ type: "resume", latest: true }),
  stop: () => {
    if (get().watching) {
      get().reset();
      return;
    }
    if (socket === null || !isLive(get().status)) return;
    if (get().status === "connecting") {
      hangUp();
      set({ status: "idle" });
    } else {
      socket.send({ type: "stop" });
    }
  },
  step: (by = "tick", back = false, agent = "") => {
    const { status, tick } = get();
    if (back ? tick > 0 && can("seek", get()) : status === "paused") steer({ type: "step", by, back, agent });
  },
  seek: (tick) => {
    if (can("seek", get())) seeks.ask(Math.round(tick));
  },
  force: (agent, sensor, value) => steer({ type: "force", agent, sensor, value }),
  pauseAt: (breakpoints) => steer({ type: "breakpoints", breakpoints }),
  setVariable: (agent, variable, value) => steer({ type: "set", agent, variable, value }),
  injectFault: (agent, kind) => steer({ type: "harm", agent, kind }),
  setSpeed: (speed) => {
    set({ speed });
    if (isLive(get().status)) steer({ type: "speed", value: speed });
  },
  selectAgent: (name, program) => {
    set((state) => {
      const tab = program ?? state.agents.find((one) => one.name === name)?.program;
      return tab === undefined ? {} : { selectedAgent: { ...state.selectedAgent, [tab]: name } };
    });
    sendLook(get());
  },
  reset: () => {
    hangUp();
    clearFrames();
    forgetMarks();
    set({ ...NOTHING, selectedAgent: {}, failRate: 0 });
  },
  dismissError: () => set({ error: null, problems: [] }),
}));

/** The agent that is watched for a program: the chosen one, else the first. */
export function watchedAgent(state: Pick<RunState, "agents" | "selectedAgent">, program: string): RunAgent | undefined {
  const chosen = state.selectedAgent[program];
  let first: RunAgent | undefined;
  for (const agent of state.agents) {
    if (agent.program !== program) continue;
    if (agent.name === chosen) return agent;
    first ??= agent;
  }
  return first;
}

const NOBODY: RunAgent["active"] = [];

/**
 * Where the watched agent of a program stands: vertex → numbers of the threads there. Empty when nothing runs; a run that
 * got stuck or ran out of time still shows where everybody stood.
 */
export function useActiveVertices(program: string): Map<string, number[]> {
  const active = useRun((state) =>
    state.status === "stopped" ? NOBODY : (watchedAgent(state, program)?.active ?? NOBODY),
  );
  return useMemo(() => {
    const map = new Map<string, number[]>();
    for (const [slot, vertex] of active) map.set(vertex, [...(map.get(vertex) ?? []), slot]);
    return map;
  }, [active]);
}

/** Vertex → agents of a team that stand there, by their place in `run.agents`, as `@PLACE`. */
export type Standing = ReadonlyMap<string, readonly string[]>;

const NOBODY_STANDS: Standing = new Map();

/**
 * Where each member of a team stands in a program: the team's own, or one that stands in it by name. Who is in such a one
 * stands on the vertex with its name too, as far as `calls` says which that is.
 */
export function standingIn(
  { agents, team, status }: Pick<RunState, "agents" | "team" | "status">,
  program: string,
  calls: ReadonlyMap<string, Call>,
): Standing {
  if (team === null || status === "stopped") return NOBODY_STANDS;
  const found = new Map<string, string[]>();
  agents.forEach((agent, at) => {
    const own = agent.program === program ? agent.active.map(([, vertex]) => vertex) : [];
    const inner = (agent.inner ?? []).flatMap(([, name, vertex]) => {
      const path: Call[] = [{ program: name, vertex }];
      for (let call = calls.get(name); call !== undefined && path.length <= calls.size; call = calls.get(call.program))
        path.push(call);
      return path.flatMap((one) => (one.program === program ? [one.vertex] : []));
    });
    for (const vertex of new Set([...own, ...inner]))
      found.set(vertex, [...(found.get(vertex) ?? []), `@${String(at)}`]);
  });
  return found;
}

/** The seed of the next run. */
export function setSeed(seed: number): void {
  useRun.setState({ seed });
}

/** How probable (0…1) it is that a robot of the next run fails within a minute. */
export function setFailRate(failRate: number): void {
  useRun.setState({ failRate });
}

/** The mission was changed: what was wrong with the one that ran is the checker's matter now. */
export function forgetRunProblems(): void {
  if (useRun.getState().problems.length > 0) useRun.setState({ problems: [] });
}
