/**
 * How far a person is in a tutorial, kept in this browser for each tutorial; and what is done, as pure functions.
 *
 * `fits` is the server's word on the program as it is now, so what is undone is open again. Events cannot be undone: a
 * step whose event came while the program was right stays done, as does one that was only to be read.
 */
import type { Tutorial } from "../../api/generated";
import { parseStored, readStored, writeStored } from "../../ui/browser-storage";

export interface Progress {
  /** The step that is shown; the number of steps when all of it was gone through. */
  at: number;
  /** Steps whose event came, or that were read. */
  happened: readonly number[];
  skipped: readonly number[];
  /** The mission that is worked on: where the tutorial began, or what it was saved as. */
  path: string;
}

const KEY = "kitrobot.tutorial";

export function begun(path: string): Progress {
  return { at: 0, happened: [], skipped: [], path };
}

export function isDone({ steps }: Tutorial, step: number, fits: readonly boolean[], progress: Progress): boolean {
  const { asks, events } = steps[step] ?? { asks: false, events: [] };
  if (!asks || events.length > 0) return progress.happened.includes(step);
  return fits[step] === true;
}

/** The steps that are done now. */
export function doneSteps(tutorial: Tutorial, fits: readonly boolean[], progress: Progress): boolean[] {
  return tutorial.steps.map((_, step) => isDone(tutorial, step, fits, progress));
}

/** Where to go on after a step: the next that is neither done nor skipped, else one before it, else the end. */
export function nextStep(done: readonly boolean[], skipped: readonly number[], after: number): number {
  const open = done.map((is, step) => (is || skipped.includes(step) ? -1 : step)).filter((step) => step >= 0);
  return open.find((step) => step > after) ?? open[0] ?? done.length;
}

/** What was remembered, as far as it makes sense for a tutorial of that many steps; null for nothing. */
export function readProgress(text: string | null, steps: number): Progress | null {
  const found = parseStored(text);
  if (typeof found !== "object" || found === null) return null;
  const { at, happened, skipped, path } = found as Record<string, unknown>;
  if (typeof at !== "number" || typeof path !== "string" || !Number.isInteger(at)) return null;
  const numbers = (value: unknown) =>
    Array.isArray(value)
      ? [...new Set(value)].filter(
          (one): one is number => typeof one === "number" && Number.isInteger(one) && one >= 0 && one < steps,
        )
      : [];
  return {
    at: Math.min(Math.max(at, 0), steps),
    happened: numbers(happened),
    skipped: numbers(skipped),
    path,
  };
}

/** The progress in a tutorial; null where it was never begun. */
export function rememberedProgress(tutorial: Tutorial): Progress | null {
  return readProgress(readStored(`${KEY}.${tutorial.name}`), tutorial.steps.length);
}

export function rememberProgress(name: string, progress: Progress): void {
  writeStored(`${KEY}.${name}`, JSON.stringify(progress));
}

/** The tutorial that is open in this browser; "" for none. */
export function openTutorial(): string {
  return readStored(KEY) ?? "";
}

export function rememberOpen(name: string): void {
  writeStored(KEY, name === "" ? null : name);
}

/** Whether the welcome was shown already. */
export function isWelcomed(): boolean {
  return readStored(`${KEY}.welcomed`) !== null;
}

export function rememberWelcomed(): void {
  writeStored(`${KEY}.welcomed`, "yes");
}
