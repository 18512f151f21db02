/**
 * The exercise that is open: entered with its mission, judged after each run and on demand, left with its mission.
 *
 * Judging asks the server for one piece after another (`marks.ts`). Stop asks for no more, and the piece that is on answers
 * with what it has found. The marks are of the mission as it was asked about; an edit makes them old and stops what is under way.
 */
import { create } from "zustand";

import { ApiError } from "../../api/client";
import { exerciseApi } from "../../api/exercises";
import type { Exercise } from "../../api/generated";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import type { Mission } from "../../model/types";
import { isHeldByRobots } from "../../session/confirming-run";
import { reportError, show, whenReady } from "../../session/document";
import { setOpenLesson } from "../../session/lessons";
import { remember, setGoals, useOpenExercise, workedOn, workPlace } from "../../session/open-exercise";
import { openMissionOfLesson } from "../../session/open-requests";
import { isLive, useRun } from "../../session/run";
import { endAll, listen } from "../../ui/effects";
import { forgetHash } from "../../ui/page-hash";
import { groundOf, type Mark, noMarks, pieces, withVerdicts } from "./marks";

/** What the marks are of: nothing yet, one run, every run, or as far as judging came before it was stopped. */
export type Basis =
  { kind: "none" } | { kind: "run"; seed: number } | { kind: "all"; runs: number } | { kind: "stopped" };

interface ExerciseState {
  /** All exercises; null until the server has answered. */
  all: readonly Exercise[] | null;
  marks: readonly Mark[];
  basis: Basis;
  /** Whether the mission was edited since. */
  old: boolean;
  /** How far judging is; null while none is on. */
  busy: { done: number; total: number } | null;
  /** What was judged: a failing run is played from it. */
  judged: Mission | null;
}

const NOTHING = {
  marks: [] as readonly Mark[],
  basis: { kind: "none" } as Basis,
  old: false,
  busy: null,
  judged: null,
};

export const useExercise = create<ExerciseState>(() => ({ all: null, ...NOTHING }));

const set = useExercise.setState;
let asking = new AbortController();
/** The name of the judging that is on, and whether it is to end. */
let judging = "";
let stopping = false;

/** Asks which exercises there are; a folder may have got another one. */
export async function lookForExercises(): Promise<void> {
  try {
    set({ all: await exerciseApi.all() });
  } catch (cause) {
    if (useExercise.getState().all !== null) return;
    set({ all: [] });
    reportError(cause);
  }
}

/** The exercise that is open, once it is known which there are. */
export function openExercise(): Exercise | null {
  const { open } = useOpenExercise.getState();
  const found = useExercise.getState().all?.find(({ name }) => name === open?.name);
  return found === undefined || found.goals.length === 0 ? null : found;
}

/** Opens the mission of an exercise, and its checklist with it. */
export function begin(exercise: Exercise): void {
  show(null);
  reset();
  remember({ name: exercise.name, path: exercise.start });
  if (useStudio.getState().file.path !== exercise.start) openMissionOfLesson(exercise.start);
}

/** Opens the exercise of a link, once the page has begun; where it is open already what was done stays. */
export async function openLinked(name: string): Promise<void> {
  await whenReady();
  forgetHash();
  await lookForExercises();
  const found = useExercise.getState().all?.find((one) => one.name === name);
  if (found === undefined || found.goals.length === 0)
    reportError(new ApiError(t("exercise.no-link", { name }), t("exercise.no-link-help")));
  else if (workedOn(useStudio.getState().file) !== name) begin(found);
}

export function leave(): void {
  reset();
  remember(null);
}

function reset(): void {
  drop();
  set(NOTHING);
}

/** Nobody waits for the judging that is on any more. */
function drop(): void {
  if (useExercise.getState().busy !== null) askToStop();
  asking.abort();
}

function askToStop(): void {
  stopping = true;
  // Where the server does not hear it, the piece that is on ends by itself.
  exerciseApi.stop(judging).catch(() => undefined);
}

/** Judges these pieces; `known` are the marks that others gave. */
async function judge(
  seeds: readonly (number | null)[],
  basis: Basis,
  of: Mission,
  known?: readonly Mark[],
): Promise<void> {
  const exercise = openExercise();
  if (exercise === null) return;
  drop();
  const mine = (asking = new AbortController());
  const name = (judging = String(Math.random()));
  stopping = false;
  const marks = known ?? noMarks(exercise);
  set({ marks, basis: { kind: "none" }, old: false, busy: { done: 0, total: seeds.length } });
  try {
    for (const [done, seed] of seeds.entries()) {
      const { goals, mission } = await exerciseApi.judge(exercise.name, of, seed, name, mine.signal);
      if (mine.signal.aborted) return;
      const found = withVerdicts(useExercise.getState().marks, goals, exercise.goals);
      set({ marks: found, judged: mission, busy: { done: done + 1, total: seeds.length } });
      if (isStopping()) {
        set({ basis: { kind: "stopped" }, busy: null });
        return;
      }
    }
    set({ basis, busy: null });
  } catch (cause) {
    if (mine.signal.aborted) return;
    set({ busy: null });
    reportError(cause);
  }
}

/** Judges every run, and what is checked. */
export function judgeAll(): void {
  const exercise = openExercise();
  if (exercise === null) return;
  void judge(pieces(exercise), { kind: "all", runs: exercise.seeds.length }, useStudio.getState().mission);
}

/** Judges a run that has ended; where that left no goal missed, the other runs too, and what is checked. */
async function judgeRun(seed: number, of: Mission): Promise<void> {
  const exercise = openExercise();
  if (exercise === null) return;
  const all: Basis = { kind: "all", runs: exercise.seeds.length };
  const rest = pieces(exercise).filter((piece) => piece !== seed);
  await judge([seed], rest.length === 0 ? all : { kind: "run", seed }, of);
  const { basis, old, marks } = useExercise.getState();
  if (basis.kind === "run" && !old && marks.every(({ state }) => state !== "missed")) await judge(rest, all, of, marks);
}

/** Whether every goal is reached in every run, as the mission is now. */
function isSolved(): boolean {
  const { basis, old, marks } = useExercise.getState();
  return basis.kind === "all" && !old && marks.length > 0 && marks.every(({ state }) => state === "reached");
}

/** Says which exercise is open, and whether it is solved. */
function tellLesson(): void {
  const exercise = openExercise();
  setOpenLesson("exercise", exercise === null ? null : { name: exercise.name, done: isSolved() });
}

/** What was found until now stays. */
export function stopJudging(): void {
  if (useExercise.getState().busy !== null) askToStop();
}

// As a function, so that what is awaited may change it.
function isStopping(): boolean {
  return stopping;
}

/** Plays the run that shows what went wrong. */
export function play(mark: Mark): void {
  const exercise = openExercise();
  const { judged } = useExercise.getState();
  if (exercise === null || judged === null || mark.seed === null || isHeldByRobots()) return;
  const like = { mission: judged, path: exercise.start, seed: mark.seed, seconds: exercise.seconds, fail_rate: 0 };
  const { mission, file } = useStudio.getState();
  playing = true;
  useRun.getState().start({ mission, path: file.path }, like);
}

/** Whether the run that is on is one that was judged already. */
let playing = false;

/** Starts looking after the exercise that is open; the returned function ends it. */
export function keepExercise(): () => void {
  void lookForExercises();
  const offStudio = useStudio.subscribe((state, before) => {
    const { open } = useOpenExercise.getState();
    if (open === null) return;
    if (state.change !== before.change && state.change.kind === "open") {
      if (workPlace(state.file) === open.path) reset();
      else leave();
    } else if (workPlace(state.file) !== workPlace(before.file)) {
      remember({ ...open, path: workPlace(state.file) });
    } else if (state.mission !== before.mission) {
      if (useExercise.getState().busy !== null) stopJudging();
      set({ old: true });
    }
  });
  const offRun = useRun.subscribe((state, before) => {
    if (!isLive(before.status) || isLive(state.status) || state.recording || state.real || state.watching) return;
    if (state.status === "idle" || state.status === "stopped" || state.mission === null) return;
    const was = playing;
    playing = false;
    if (!was && useExercise.getState().busy === null) {
      void judgeRun(state.seed, state.mission);
    }
  });
  const offOpen = useOpenExercise.subscribe(tellLesson);
  const offMarks = useExercise.subscribe(({ marks }, before) => {
    tellLesson();
    if (marks === before.marks) return;
    setGoals(
      marks.map((mark) => ({ reached: mark.state === "open" ? null : mark.state === "reached", why: groundOf(mark) })),
    );
  });
  const offFocus = listen(window, { focus: () => void lookForExercises() });
  return endAll(drop, offStudio, offRun, offMarks, offOpen, offFocus, () => setOpenLesson("exercise", null));
}
