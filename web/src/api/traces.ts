/** Routes of recordings. */
import { ask, askBytes } from "./client";
import type { Judgement, Recording, RecordingEntry } from "./generated";

export const traceApi = {
  all: () => ask<RecordingEntry[]>("traces"),
  open: (path: string) => ask<Recording>(`trace?path=${encodeURIComponent(path)}`),
  read: (name: string, bytes: ArrayBuffer) =>
    ask<Recording>(`trace?name=${encodeURIComponent(name)}`, { method: "POST", bytes }),
  /** The whole past of a run, as the bytes of a `.krtrace`. */
  ofRun: (run: string) => askBytes(`run/trace?run=${encodeURIComponent(run)}`),
  /** What the mission's own properties are in all of a run so far. */
  judgements: (run: string) => ask<Judgement[]>(`run/judgements?run=${encodeURIComponent(run)}`),
  /** What a real robot did in its last run, or does in the one that is on. */
  ofRobot: (address: string) => askBytes(`board/trace?address=${encodeURIComponent(address)}`),
};
