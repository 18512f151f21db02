/**
 * The recording that is open: what it is of, and playing it; and the run that is on, saved as a recording.
 *
 * A recording brings its mission along, which is opened like any other; playing is a run that comes from a file (run).
 */
import { create } from "zustand";

import type { Recording } from "../api/generated";
import { traceApi } from "../api/traces";
import { useStudio } from "../model/studio";
import type { Mission } from "../model/types";
import { download } from "../ui/download";
import { setFailRate, setSeed, useRun } from "./run";

export interface OpenRecording {
  /** The server's name for it. */
  recording: string;
  seed: number;
  failRate: number;
  cut: boolean;
  /** Whether it is of real robots: their runs began with no seed. */
  real: boolean;
  /** Its mission as it was recorded, and where that is. */
  mission: Mission;
  path: string;
}

interface Recordings {
  open: OpenRecording | null;
}

export const useRecording = create<Recordings>(() => ({ open: null }));

const ENDING = ".krtrace";

export function isRecording(name: string): boolean {
  return name.toLowerCase().endsWith(ENDING);
}

/** Whether a mission came with a recording: it has no file of its own yet. */
export function isFromRecording(path: string): boolean {
  return path.startsWith("recording:");
}

/** The recording that belongs to the mission that is open, or null. */
export function useOpenRecording(): OpenRecording | null {
  const open = useRecording((state) => state.open);
  const path = useStudio((studio) => studio.file.path);
  return open?.path === path ? open : null;
}

/** Plays a recording whose mission has just been opened. */
export function begin({ recording, seed, fail_rate, cut, real, file }: Recording): void {
  const { mission, path } = file;
  useRecording.setState({
    open: { recording, seed: real ? 1 : seed, failRate: fail_rate, cut, real, mission, path },
  });
  playAgain();
}

export function playAgain(): void {
  const { open } = useRecording.getState();
  if (open === null) return;
  // Breakpoints are not of the recording: those that stand now are meant.
  const { breakpoints = [] } = useStudio.getState().mission;
  useRun.getState().replay({ mission: open.mission, recording: open.recording, breakpoints });
}

/** A live run of the mission as it was recorded, with the same seed. */
export function runRecorded(): void {
  const { open } = useRecording.getState();
  if (open === null) return;
  setSeed(open.seed);
  setFailRate(open.failRate);
  useRun.getState().start({ mission: open.mission, path: open.path });
}

/** Downloads the run so far as a recording. */
export async function saveRun(): Promise<void> {
  const { name, seed } = useRun.getState();
  const stem = (useStudio.getState().file.name.split("/").at(-1) ?? "").replace(/\.[^.]*$/, "") || "run";
  download(`${stem}-${String(seed)}${ENDING}`, await traceApi.ofRun(name), "application/octet-stream");
}
