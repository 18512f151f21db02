/**
 * What travels over the run's WebSocket.
 *
 * Lengths in mm, angles in radians, x to the right, y up, heading 0 along +x and counter-clockwise. Poses come as binary
 * frames (see `decodeFrame`), everything else as JSON with a `type`.
 */
import type { Breakpoint, Mission, Problem, World } from "./types";

export type Road = World["roads"][number];
export type Dock = World["docks"][number];
export type Storehouse = World["storehouses"][number];

export type AgentActivity = "running" | "waiting" | "idle" | "failed" | "stalled";
export type RunOutcome = "done" | "failed" | "stuck" | "time" | "stopped";

export interface StartedAgent {
  name: string;
  program: string;
  robot: string;
  number: number;
  kind: string;
  /** Whether it is known where it is; of a real robot nobody knows. */
  placed: boolean;
}

export interface AgentReport {
  active: [slot: number, vertex: string][];
  state: AgentActivity;
  values: Record<string, number>;
  inputs: Record<string, number>;
  /** What its displays and the like show, by the name of the actuator: the numbers that a trace has of it. */
  shown: Record<string, number[]>;
  fault: number;
  /** Sensors in whose place a value stands. */
  forced: string[];
}

/** Why a run pauses: an agent came to the vertex of a breakpoint. */
export interface Hit {
  program: string;
  vertex: string;
  agent: string;
  visit: number;
}

export type RunEventKind = "load" | "unload" | "message" | "collision" | "failure" | "revival" | "end" | "outside";

/** What brings an event about: `mission` is its schedule, `person` somebody's hand during the run. */
export type RunEventCause = "program" | "world" | "person" | "mission" | "chance" | "robot" | "link";

export interface RunEvent {
  tick: number;
  kind: RunEventKind;
  agent: string;
  text: string;
  cause: RunEventCause;
}

export type RunMessage =
  | {
      type: "started";
      run: string | number;
      tick_ms: number;
      seed: number;
      world: World | null;
      agents: StartedAgent[];
      stock: Record<string, number>;
      total: number;
      /** Whether it is played from a recording. */
      recording: boolean;
      /** The probability (0…1) that a robot fails by chance within a minute. */
      fail_rate: number;
      /** Whether another page steers it; `another`: what runs there is not the mission that is open here. */
      watching: boolean;
      another: boolean;
    }
  | {
      type: "state";
      /** `end` is where a recording ends whose run was still on. */
      status: "running" | "paused" | "end" | RunOutcome;
      tick: number;
      seconds: number;
      sentence: string;
      hits: Hit[];
      /** Hints on a run that ended before anything could be seen. */
      problems: Problem[];
    }
  | {
      type: "tick";
      tick: number;
      /** The furthest tick of this future; less than before when another one has begun. */
      latest: number;
      /** Whether `events` are all up to `latest`, not only those since the last message. */
      again: boolean;
      seconds: number;
      agents: Record<string, AgentReport>;
      stock: Record<string, number>;
      delivered: Record<string, number>;
      collisions: number;
      events: RunEvent[];
    }
  | { type: "problems"; problems: Problem[] }
  | { type: "error"; message: string; help: string; ended: boolean };

/** What can befall a robot. */
export type Harm = "fail" | "stall" | "mute" | "revive";

export type RunRequest =
  | { type: "replay"; recording: string; speed: number }
  | { type: "start"; mission: Mission; path: string; seed: number; speed: number; fail_rate: number }
  | { type: "watch"; run: string; mission: Mission }
  | { type: "pause" }
  | { type: "resume" }
  | { type: "stop" }
  | { type: "step"; by: "tick" | "vertex"; back: boolean; agent: string }
  | { type: "seek"; tick: number }
  | { type: "force"; agent: string; sensor: string; value: number | null }
  | { type: "set"; agent: string; variable: string; value: number }
  | { type: "harm"; agent: string; kind: Harm }
  | { type: "look"; agents: string[] }
  | { type: "breakpoints"; breakpoints: Breakpoint[] }
  | { type: "speed"; value: number };

/** One robot as a frame shows it. */
export interface Pose {
  x_mm: number;
  y_mm: number;
  heading_rad: number;
  load: number;
  flags: number;
}

export const LAMP = 1;
export const FAILED = 2;
export const COLLISION = 4;
export const ARM_OUT = 8;
export const MOVING = 16;
export const STALLED = 32;
export const MUTED = 64;

export interface PoseFrame {
  tick: number;
  poses: Pose[];
}

const FIELDS = 5;
const HEAD = 2;

/** A binary frame, or null when its length does not fit what it says. */
export function decodeFrame(data: ArrayBuffer): PoseFrame | null {
  if (data.byteLength % 4 !== 0 || data.byteLength < HEAD * 4) return null;
  const view = new DataView(data);
  const read = (index: number) => view.getFloat32(index * 4, true);
  const count = read(1);
  if (!Number.isInteger(count) || count < 0 || data.byteLength !== (HEAD + count * FIELDS) * 4) return null;
  const poses: Pose[] = [];
  for (let robot = 0; robot < count; robot++) {
    const at = HEAD + robot * FIELDS;
    poses.push({
      x_mm: read(at),
      y_mm: read(at + 1),
      heading_rad: read(at + 2),
      load: read(at + 3),
      flags: read(at + 4),
    });
  }
  return { tick: read(0), poses };
}
