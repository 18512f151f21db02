/** Routes of exercises: which there are, and what came of judging a piece of one. */
import type { Mission } from "../model/types";
import { ask } from "./client";
import type { Exercise, Judged } from "./generated";

export const exerciseApi = {
  all: () => ask<Exercise[]>("exercises"),
  /** Puts the files of an exercise that a class handed out (a ZIP file) into the studio. */
  keep: (exercise: string, bytes: ArrayBuffer) =>
    ask<boolean>(`handed-out?exercise=${encodeURIComponent(exercise)}`, { method: "PUT", bytes }),
  /** The run of that seed, or without one what is checked; `judging` names it for `stop`. */
  judge: (exercise: string, mission: Mission, seed: number | null, judging: string, signal: AbortSignal) =>
    ask<Judged>("exercise/judge", { method: "POST", json: { exercise, mission, seed, judging }, signal }),
  /** The judging of that name answers with what it has found. */
  stop: (judging: string) => ask<boolean>("exercise/stop", { method: "POST", json: { judging } }),
};
