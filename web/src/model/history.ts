/**
 * The history of a document as plain values: what undo and redo go through, and what the journal keeps and gives back.
 *
 * A `History` is the mission with the steps before it and the steps that were taken back. Missions share what they have in
 * common. Left to others: when a step joins the one before (`studio.ts`), how a history is written down (`delta.ts`,
 * `session/journal-records.ts`).
 */
import type { Mission } from "./types";

/** One change of the document. */
export interface Step {
  label: string;
  /** The program in view when it was made. */
  program: string;
  before: Mission;
  after: Mission;
  /** What was selected before it and is selected after it; unknown of steps that were read from a journal. */
  selection?: string[];
  selects?: string[] | undefined;
  /** Steps with the same key that follow each other closely are one. */
  joins?: string | undefined;
  /** When it was made, in ms of `Date.now`. */
  at_ms?: number;
}

/** What of a step a `Change` does not say. */
export type StepDetails = Pick<Step, "selection" | "selects" | "joins" | "at_ms">;

export interface History {
  mission: Mission;
  past: readonly Step[];
  /** What was taken back, the next one to do again last. */
  future: readonly Step[];
  /** How many steps of the past were done when the file was written; -1 when no undo leads there. */
  saved: number;
}

/**
 * What the store did last: `do` a step, `join` to the step before, `undo`, `redo`, `open` or `save`. `saved` is as in
 * `History`, after it.
 */
export interface Change {
  kind: "open" | "do" | "join" | "undo" | "redo" | "save";
  label: string;
  program: string;
  saved: number;
}

export function historyOf(mission: Mission): History {
  return { mission, past: [], future: [], saved: 0 };
}

export function isUnsaved({ past, saved }: History): boolean {
  return past.length !== saved;
}

/** The history after a change that led to `mission`; the same history when the change does not belong to it. */
export function follow(
  history: History,
  { kind, label, program, saved }: Change,
  mission: Mission,
  details: StepDetails = {},
): History {
  const { past, future } = history;
  const last = past.at(-1);
  switch (kind) {
    case "open":
      return historyOf(mission);
    case "save":
      return { ...history, saved };
    case "do":
      return {
        mission,
        past: [...past, { label, program, before: history.mission, after: mission, ...details }],
        future: [],
        saved,
      };
    case "join":
      if (last === undefined) return history;
      return {
        mission,
        past: [...past.slice(0, -1), { ...last, ...details, label, after: mission }],
        future: [],
        saved,
      };
    case "undo":
      if (last === undefined) return history;
      return { mission: last.before, past: past.slice(0, -1), future: [...future, last], saved };
    case "redo": {
      const next = future.at(-1);
      if (next === undefined) return history;
      return { mission: next.after, past: [...past, next], future: future.slice(0, -1), saved };
    }
  }
}
