/**
 * The experiment of this page: what is asked of the server, how far it is, the study that is looked at, and its runs.
 *
 * Studies lie in folders beside their mission, so they are there after the page was loaded again; work on one ends with the
 * page, and what ended is kept. Another mission that is opened forgets all of it here.
 */
import { create } from "zustand";

import { experimentApi, type StudyPlace } from "../../api/experiments";
import type {
  ExperimentAsk,
  ExperimentChoices,
  ExperimentPlan,
  ExperimentProgressMessage,
  ExperimentResumeRequest,
  ExperimentStudyMessage,
  Study,
  StudyRun,
  WorkRefusedMessage,
} from "../../api/generated";
import { type WhyRefused, whyRefused } from "../../api/refusal";
import { beginWork, type Work } from "../../api/work";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { isHeldByRobotsOrFleet } from "../../session/confirming-run";
import { reportError } from "../../session/document";
import { useRun } from "../../session/run";
import { download } from "../../ui/download";

type Message = ExperimentProgressMessage | ExperimentStudyMessage | WorkRefusedMessage;

/** Of a study with more runs than this those of one point are fetched at a time. */
const MOST_AT_ONCE = 2000;

interface StudyState {
  choices: ExperimentChoices | null;
  /** What the study that is set up would be; null while nobody knows. */
  plan: ExperimentPlan | null;
  /** Why there is none. */
  wrong: WhyRefused | null;
  /** How far the work is that is on; null while none is. */
  busy: { done: number; total: number; left: number | null } | null;
  /** Why work on a study ended without it. */
  refused: WhyRefused | null;
  study: Study | null;
  /** The path of the mission beside which the study lies. */
  path: string;
  /** The number of the point whose runs are shown. */
  point: number;
  runs: readonly StudyRun[];
  /** The row that was played last. */
  played: number | null;
}

const NOTHING: StudyState = {
  choices: null,
  plan: null,
  wrong: null,
  busy: null,
  refused: null,
  study: null,
  path: "",
  point: 0,
  runs: [],
  played: null,
};

export const useStudy = create<StudyState>(() => NOTHING);
const set = useStudy.setState;

let work: Work | null = null;

function hangUp(): void {
  work?.hangUp();
  work = null;
}

function wasCalledOff(cause: unknown): boolean {
  return cause instanceof DOMException && cause.name === "AbortError";
}

/** Asks what the open mission has; the newest of its studies is shown where none is. */
export async function fetchChoices(signal: AbortSignal): Promise<void> {
  const { mission, file } = useStudio.getState();
  try {
    const choices = await experimentApi.choices(mission, file.path, signal);
    set({ choices });
    const [newest] = choices.studies;
    const { study, busy } = useStudy.getState();
    if (newest !== undefined && study === null && busy === null) await openStudy(newest.study);
  } catch (cause) {
    if (!wasCalledOff(cause)) set({ refused: whyRefused(cause) });
  }
}

/** Asks what a study would be. */
export async function fetchPlan(asked: ExperimentAsk, signal: AbortSignal): Promise<void> {
  try {
    set({ plan: await experimentApi.plan(asked, signal), wrong: null });
  } catch (cause) {
    if (!wasCalledOff(cause)) set({ plan: null, wrong: whyRefused(cause) });
  }
}

export async function openStudy(name: string): Promise<void> {
  const { path } = useStudio.getState().file;
  try {
    const study = await experimentApi.study({ path, study: name });
    set({ study, path, point: 0, runs: [], played: null, refused: null });
    await fetchRuns();
  } catch (cause) {
    set({ refused: whyRefused(cause) });
  }
}

function place(): StudyPlace | null {
  const { study, path } = useStudy.getState();
  return study === null ? null : { path, study: study.study };
}

/** Whether all runs of a study are fetched together. */
export function isSmall(study: Study): boolean {
  return study.total <= MOST_AT_ONCE;
}

async function fetchRuns(): Promise<void> {
  const { study, point } = useStudy.getState();
  const where = place();
  if (study === null || where === null) return;
  const [first, count] = isSmall(study) ? [0, study.total] : [point * study.seeds, study.seeds];
  try {
    const runs = await experimentApi.runs(where, first, count);
    const now = useStudy.getState();
    // Another study, or another point of it, may have been chosen meanwhile.
    if (now.study?.study === study.study && (isSmall(study) || now.point === point)) set({ runs });
  } catch (cause) {
    set({ refused: whyRefused(cause) });
  }
}

/** The runs of a point that are over and known here. */
export function runsOf({ runs, study }: Pick<StudyState, "runs" | "study">, point: number): StudyRun[] {
  const seeds = study?.seeds ?? 1;
  return runs.filter(({ row }) => Math.floor(row / seeds) === point);
}

/** Shows the runs of a point. */
export function choosePoint(point: number): void {
  const { study } = useStudy.getState();
  set({ point });
  if (study !== null && !isSmall(study)) void fetchRuns();
}

function show(study: Study, path: string): void {
  const before = useStudy.getState();
  const same = before.study?.study === study.study && before.path === path;
  set({ study, path, ...(same ? {} : { point: 0, runs: [], played: null }) });
  void fetchRuns();
}

function start(request: (ExperimentAsk & { type: "start" }) | ExperimentResumeRequest): void {
  hangUp();
  set({ refused: null, busy: { done: 0, total: 0, left: null } });
  work = beginWork<Message>("api/experiment", request, {
    onMessage: (message) => {
      if (message.type === "progress") {
        set({ busy: { done: message.done, total: message.total, left: message.left_s } });
        if (message.study !== null) show(message.study, request.path);
        return false;
      }
      set({ busy: null });
      if (message.type === "refused") set({ refused: message });
      else {
        show(message.study, request.path);
        noteStudy(message.study);
      }
      return true;
    },
    onLost: () => set({ busy: null, refused: { message: t("experiment.lost"), help: "", problems: [] } }),
  });
}

/** A study that was begun just now is among those of the mission. */
function noteStudy({ study, total }: Study): void {
  set(({ choices }) => {
    if (choices === null || choices.studies.some((one) => one.study === study)) return {};
    return { choices: { ...choices, studies: [{ study, runs: total }, ...choices.studies] } };
  });
}

export function begin(asked: ExperimentAsk): void {
  start({ type: "start", ...asked });
}

/** Goes on with the study that is shown. */
export function resume(): void {
  const where = place();
  if (where !== null) start({ type: "resume", ...where });
}

/** Ends the work; every run that has ended is kept. */
export function breakOff(): void {
  if (work?.breakOff() === true) return;
  hangUp();
  set({ busy: null });
}

/** Plays the very run of a row, in the place of what was on. */
export async function playRow(row: number): Promise<void> {
  const where = place();
  if (where === null || isHeldByRobotsOrFleet()) return;
  set({ played: row });
  try {
    const { recording } = await experimentApi.replay(where, row);
    const { mission } = useStudio.getState();
    if (useStudy.getState().played === row)
      useRun.getState().replay({ mission, recording, breakpoints: mission.breakpoints ?? [] });
  } catch (cause) {
    set({ played: null });
    reportError(cause);
  }
}

/** Downloads the rows of the study that is shown. */
export async function downloadTable(): Promise<void> {
  const where = place();
  if (where === null) return;
  try {
    download(`${where.study}.csv`, await experimentApi.table(where), "text/csv");
  } catch (cause) {
    reportError(cause);
  }
}

useStudio.subscribe((studio, before) => {
  if (studio.change === before.change || studio.change.kind !== "open") return;
  hangUp();
  set(NOTHING);
});
