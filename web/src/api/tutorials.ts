/** The server's doors to tutorials: which there are, and what of one is done. */
import { ask } from "./client";
import type { Mission, Problem, Texts } from "./types";

/** Something of the page that a step points at; `inner` is a setting or slot of a vertex, or "". */
export interface Point {
  kind: "part" | "vertex" | "button" | "panel" | "program";
  name: string;
  inner: string;
}

export interface TutorialStep {
  label: Texts;
  help: Texts;
  hint: Texts;
  points: Point[];
  /** The program has to be in some way. */
  asks: boolean;
  /** One of these has to happen while it is so. */
  events: string[];
}

/** A tutorial; one that cannot be used has no steps but problems. */
export interface Tutorial {
  name: string;
  /** The mission it begins with. */
  start: string;
  label: Texts;
  help: Texts;
  icon: string;
  steps: TutorialStep[];
  problems: Problem[];
}

export interface TutorialFit {
  /** For each step, whether the programs are as it wants them. */
  fits: boolean[];
}

export const tutorialApi = {
  all: () => ask<Tutorial[]>("tutorials"),
  watch: (tutorial: string, mission: Mission, path: string, signal?: AbortSignal) =>
    ask<TutorialFit>("tutorial/watch", {
      method: "POST",
      json: { tutorial, mission, path },
      ...(signal === undefined ? {} : { signal }),
    }),
};
