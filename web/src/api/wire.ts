/**
 * What travels over the run's WebSocket.
 *
 * Lengths in mm, angles in radians, x to the right, y up, heading 0 along +x and counter-clockwise. Poses come as binary
 * frames (see `decodeFrames`), everything else as JSON with a `type`.
 */
import type { AgentReport, HarmRequest, RunEvent, StartedMessage, StateMessage } from "./generated";

export type {
  AgentReport,
  DockPose,
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
const HEAD = 3;

/**
 * Binary frames, one after another: where the robots are, after the way that they went there. Empty when the length does not
 * fit what they say.
 */
export function decodeFrames(data: ArrayBuffer): PoseFrame[] {
  if (data.byteLength % 4 !== 0) return [];
  const view = new DataView(data);
  const [read, length] = [(index: number) => view.getFloat32(index * 4, true), data.byteLength / 4];
  const frames: PoseFrame[] = [];
  for (let at = 0; at < length;) {
    const [robots, things] = at + HEAD > length ? [-1, -1] : [read(at + 1), read(at + 2)];
    if (!(Number.isInteger(robots) && Number.isInteger(things) && robots >= 0 && things >= 0)) return [];
    const end = at + HEAD + robots * FIELDS + things * 2;
    if (end > length) return [];
    const frame = { tick: read(at), poses: [] as Pose[], things: [] as [number, number][] };
    at += HEAD;
    for (const first = at; at < first + robots * FIELDS; at += FIELDS) {
      const [x_mm, y_mm, heading_rad] = [read(at), read(at + 1), read(at + 2)];
      frame.poses.push({ x_mm, y_mm, heading_rad, load: read(at + 3), flags: read(at + 4) });
    }
    for (; at < end; at += 2) frame.things.push([read(at), read(at + 1)]);
    frames.push(frame);
  }
  return frames;
}
