/**
 * Where the robots are: the last two frames of a run, outside React's state because they change thirty times a second.
 *
 * The arena draws one frame late and in between: at `poseAt(now)` each robot is on its way from the last frame but one to
 * the last one. Frames that come slowly (single steps) are walked through in at most `LONGEST_MS`.
 */
import type { Pose, PoseFrame } from "../api/wire";

interface Arrived extends PoseFrame {
  at: number;
}

const LONGEST_MS = 120;
/** Further than this in one frame is a jump, not a movement. */
const JUMP_MM = 600;

let before: Arrived | null = null;
let last: Arrived | null = null;
/** All frames of the run so far, while nobody records them. */
let early: PoseFrame[] = [];
/** So many places of robots are kept for who comes late. */
const MOST_EARLY = 400_000;
let recorder: Recorder | null = null;
const watchers = new Set<() => void>();

/** `joined`: somebody saw which way led there from the frame before. */
type Recorder = (frame: PoseFrame, joined: boolean) => void;

/** Calls back with each frame of a run from its first one, however late somebody asks; the returned function ends it. */
export function recordFrames(record: Recorder): () => void {
  early.forEach((frame, at) => record(frame, at > 0));
  early = [];
  recorder = record;
  return () => {
    if (recorder === record) recorder = null;
  };
}

function keep(frame: PoseFrame, joined: boolean): void {
  if (recorder !== null) recorder(frame, joined);
  else if (early.length * frame.poses.length < MOST_EARLY) early.push(frame);
}

/** Calls back whenever there is something new to draw; the returned function ends it. */
export function watchFrames(callback: () => void): () => void {
  watchers.add(callback);
  return () => watchers.delete(callback);
}

/** `gone`: where the robots were on the way to it, where that was long. */
export function pushFrame(frame: PoseFrame, now: number, gone: readonly PoseFrame[] = []): void {
  before = last !== null && last.poses.length === frame.poses.length && frame.tick >= last.tick ? last : null;
  last = { ...frame, at: now };
  for (const one of gone) keep(one, true);
  keep(frame, gone.length > 0);
  for (const callback of watchers) callback();
}

export function clearFrames(): void {
  before = null;
  last = null;
  early = [];
  for (const callback of watchers) callback();
}

/** The last frame that came; null before the first. */
export function lastFrame(): PoseFrame | null {
  return last;
}

function turn(from: number, to: number, share: number): number {
  const difference = Math.atan2(Math.sin(to - from), Math.cos(to - from));
  return from + difference * share;
}

function between(a: Pose, b: Pose, share: number): Pose {
  if (Math.hypot(b.x_mm - a.x_mm, b.y_mm - a.y_mm) > JUMP_MM) return b;
  return {
    ...b,
    x_mm: a.x_mm + (b.x_mm - a.x_mm) * share,
    y_mm: a.y_mm + (b.y_mm - a.y_mm) * share,
    heading_rad: turn(a.heading_rad, b.heading_rad, share),
  };
}

/** Where the things are that can be pushed, in the order of the world. */
export function placesOfThings(): readonly (readonly [number, number])[] {
  return last?.things ?? [];
}

export interface Shown {
  poses: readonly Pose[];
  /** False while robots are still on their way between two frames. */
  still: boolean;
}

/** The robots as they are to be drawn at `now` (ms); null before the first frame. */
export function posesAt(now: number, smooth: boolean): Shown | null {
  if (last === null) return null;
  if (before === null || !smooth) return { poses: last.poses, still: true };
  const span = Math.min(Math.max(last.at - before.at, 1), LONGEST_MS);
  const share = (now - last.at) / span;
  if (share >= 1) return { poses: last.poses, still: true };
  const from = before.poses;
  return {
    poses: last.poses.map((pose, index) => {
      const start = from[index];
      return start === undefined ? pose : between(start, pose, Math.max(share, 0));
    }),
    still: false,
  };
}
