/** The server's doors to recordings. */
import { ask, askBytes } from "./client";
import type { MissionFile } from "./types";

/** A recording that was opened, and the mission that it brought along. */
export interface Recording {
  /** By this name it is played. */
  recording: string;
  seed: number;
  /** The probability (0…1) that a robot failed by chance within a minute. */
  fail_rate: number;
  /** Whether its file ends before its run did. */
  cut: boolean;
  /** Whether it is of real robots. */
  real: boolean;
  file: MissionFile;
}

export interface RecordingEntry {
  path: string;
  name: string;
  modified: string;
  /** Why it cannot be opened; "" where nothing is known against it. */
  problem: string;
}

export const traceApi = {
  all: () => ask<RecordingEntry[]>("traces"),
  open: (path: string) => ask<Recording>(`trace?path=${encodeURIComponent(path)}`),
  read: (name: string, bytes: ArrayBuffer) =>
    ask<Recording>(`trace?name=${encodeURIComponent(name)}`, { method: "POST", bytes }),
  /** The whole past of a run, as the bytes of a `.krtrace`. */
  ofRun: (run: string) => askBytes(`run/trace?run=${encodeURIComponent(run)}`),
  /** What a real robot did in its last run, or does in the one that is on. */
  ofRobot: (address: string) => askBytes(`board/trace?address=${encodeURIComponent(address)}`),
};
