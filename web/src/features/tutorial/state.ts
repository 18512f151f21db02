/**
 * The tutorial that is on: which step is shown, what is done, and what a person does with the panel.
 *
 * Going on by itself happens once, at the moment when the shown step becomes done; who goes back to a done step stays
 * there. Left to others: opening missions (`opening.ts`), asking the server (`step-watch.ts`).
 */
import { create } from "zustand";

import type { Tutorial } from "../../api/generated";
import {
  doneSteps,
  isDone,
  isWelcomed,
  nextStep,
  type Progress,
  rememberOpen,
  rememberProgress,
  rememberWelcomed,
} from "./progress";

interface TutorialState {
  /** All tutorials; null until the server has answered. */
  all: readonly Tutorial[] | null;
  tutorial: Tutorial | null;
  progress: Progress;
  fits: readonly boolean[];
  /** Whether the hint is shown: after asking. */
  hinted: boolean;
  /** The step that was done last, to say so; -1 for none. */
  last: number;
  welcomed: boolean;
}

const NOTHING = {
  tutorial: null,
  progress: { at: 0, happened: [], skipped: [], path: "" } as Progress,
  fits: [] as readonly boolean[],
  hinted: false,
  last: -1,
};

export const useTutorial = create<TutorialState>(() => ({ all: null, ...NOTHING, welcomed: isWelcomed() }));

const set = useTutorial.setState;

export function setTutorials(all: readonly Tutorial[]): void {
  set({ all });
}

/** Whether the shown step was done already when it was opened: then the tutorial does not go on by itself. */
let wasDone = false;

function keep(progress: Progress): void {
  const { tutorial } = useTutorial.getState();
  set({ progress });
  if (tutorial !== null) rememberProgress(tutorial.name, progress);
}

/** Puts a tutorial into the panel. */
export function enter(tutorial: Tutorial, progress: Progress): void {
  wasDone = false;
  set({ ...NOTHING, tutorial });
  keep(progress);
  rememberOpen(tutorial.name);
  welcome();
}

/** Closes the panel; what was done is remembered. */
export function leave(): void {
  set(NOTHING);
  rememberOpen("");
}

/** The welcome is not shown again. */
export function welcome(): void {
  set({ welcomed: true });
  rememberWelcomed();
}

/** What the server says of the program as it is now. */
export function heardFits(fits: readonly boolean[]): void {
  set({ fits });
  goOnWhenDone();
}

/** Something happened while the program was as `fits` says. */
export function heardEvent(event: string, fits: readonly boolean[]): void {
  const { tutorial, progress } = useTutorial.getState();
  if (tutorial === null) return;
  const now = tutorial.steps.flatMap((step, index) =>
    step.events.includes(event) && fits[index] === true && !progress.happened.includes(index) ? [index] : [],
  );
  if (now.length > 0) keep({ ...progress, happened: [...progress.happened, ...now] });
  goOnWhenDone();
}

function goOnWhenDone(): void {
  const { tutorial, progress, fits } = useTutorial.getState();
  if (tutorial === null || progress.at >= tutorial.steps.length) return;
  const done = doneSteps(tutorial, fits, progress);
  if (done[progress.at] !== true) wasDone = false;
  else if (!wasDone) {
    set({ last: progress.at, hinted: false });
    keep({ ...progress, at: nextStep(done, progress.skipped, progress.at) });
  }
}

/** Shows a step, whatever its state. */
export function goTo(step: number): void {
  const { tutorial, progress, fits } = useTutorial.getState();
  if (tutorial === null) return;
  const at = Math.min(Math.max(step, 0), tutorial.steps.length);
  wasDone = isDone(tutorial, at, fits, progress);
  set({ hinted: false, last: -1 });
  keep({ ...progress, at });
}

export function goBack(): void {
  goTo(useTutorial.getState().progress.at - 1);
}

/** Goes on without doing the step; one that is only to be read is done by it. */
export function goForward(): void {
  const { tutorial, progress, fits } = useTutorial.getState();
  const step = tutorial?.steps[progress.at];
  if (tutorial === null || step === undefined) return;
  const { at } = progress;
  if (isDone(tutorial, at, fits, progress)) {
    goTo(at + 1);
    return;
  }
  const read = !step.asks && step.events.length === 0;
  keep(
    read
      ? { ...progress, happened: [...progress.happened, at] }
      : { ...progress, skipped: [...progress.skipped.filter((one) => one !== at), at] },
  );
  goTo(at + 1);
}

export function showHint(): void {
  set({ hinted: true });
}

/** The mission was saved somewhere else: that is where to go on. */
export function movedTo(path: string): void {
  const { tutorial, progress } = useTutorial.getState();
  if (tutorial !== null && path !== progress.path) keep({ ...progress, path });
}
