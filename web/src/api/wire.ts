/**
 * What travels over the run's WebSocket.
 *
 * Lengths in mm, angles in radians, x to the right, y up, heading 0 along +x and counter-clockwise. Poses come as binary
 * frames (see `decodeFrame`), everything else as JSON with a `type`.
 */
import type { AgentReport, HarmRequest, RunEvent, StartedMessage, StateMessage } from "./generated";

export type {
  AgentReport,
  Dock,
  Drawing,
  Hit,
  Road,
  RunEvent,
  RunMessage,
  RunRequest,
  StartedAgent,
  Storehouse,
} from "./generated";

/** What can be done to a run. */
export type Ability = StartedMessage["abilities"][number];
export type AgentActivity = AgentReport["state"];
/** What a run says of itself; `end` is where a recording ends whose run was still on. */
export type RunStage = StateMessage["status"];
export type RunEventKind = RunEvent["kind"];
/** What brings an event about: `mission` is its schedule, `person` an action during the run. */
export type RunEventCause = RunEvent["cause"];
/** A fault that can be injected, or the recovery from it. */
export type Harm = HarmRequest["kind"];

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
  /** Where things are that can be pushed, in mm. */
  things?: readonly (readonly [number, number])[];
}

const FIELDS = 5;
const HEAD = 2;

/** A binary frame, or null when its length does not fit what it says. */
export function decodeFrame(data: ArrayBuffer): PoseFrame | null {
  if (data.byteLength % 4 !== 0 || data.byteLength < HEAD * 4) return null;
  const view = new DataView(data);
  const read = (index: number) => view.getFloat32(index * 4, true);
  const count = read(1);
  if (!Number.isInteger(count) || count < 0) return null;
  const rest = data.byteLength - (HEAD + count * FIELDS) * 4;
  if (rest < 0 || rest % 8 !== 0) return null;
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
  const things: [number, number][] = [];
  for (let at = HEAD + count * FIELDS; (at + 2) * 4 <= data.byteLength; at += 2) things.push([read(at), read(at + 1)]);
  return { tick: read(0), poses, things };
}
