/** Routes of experiments; making the runs of a study is work on a socket of its own (`api/experiment`). */
import type { Mission } from "../model/types";
import { ask, askBytes } from "./client";
import type { ExperimentAsk, ExperimentChoices, ExperimentPlan, Recording, Study, StudyRun } from "./generated";

/** Where a study lies: beside the mission of that path, in a folder of that name. */
export interface StudyPlace {
  path: string;
  study: string;
}

function query(of: Readonly<Record<string, string | number>>): string {
  return Object.entries(of)
    .map(([name, value]) => `${name}=${encodeURIComponent(value)}`)
    .join("&");
}

export const experimentApi = {
  choices: (mission: Mission, path: string, signal: AbortSignal) =>
    ask<ExperimentChoices>("experiment/choices", { method: "POST", json: { mission, path }, signal }),
  plan: (asked: ExperimentAsk, signal: AbortSignal) =>
    ask<ExperimentPlan>("experiment/plan", { method: "POST", json: asked, signal }),
  study: (place: StudyPlace) => ask<Study>(`experiment/study?${query({ ...place })}`),
  /** Of so many runs from a number on those that are over. */
  runs: (place: StudyPlace, first: number, count: number) =>
    ask<StudyRun[]>(`experiment/runs?${query({ ...place, first, count })}`),
  table: (place: StudyPlace) => askBytes(`experiment/table?${query({ ...place })}`),
  /** The run of a row, as a recording that is open now. */
  replay: (place: StudyPlace, row: number) =>
    ask<Recording>(`experiment/replay?${query({ ...place, row })}`, { method: "POST" }),
};
