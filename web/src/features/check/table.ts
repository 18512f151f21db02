/** The table of a check: a row for each property, a column for each assumption. */
import type { CheckedEvent, CheckedProperty, VerifyColumnMessage } from "../../api/generated";
import type { Cell } from "../../ui/grid";

export type { Cell };
export type Timing = VerifyColumnMessage["timing"];

export interface Assumption {
  timing: Timing;
  failures: number;
}

export const TIMINGS: readonly Timing[] = ["lockstep", "prompt", "free"];

/** What an answer looks like: a shape and a word, never a hue. */
export type Shape = "holds" | "broken" | "unconfirmed" | "cut" | "vacuous" | "running" | "waits" | "none";

/** The assumptions with up to so many failures, from the fast to the thorough. */
export function plan(failures: number): Assumption[] {
  return Array.from({ length: failures + 1 }, (_, count) =>
    TIMINGS.map((timing): Assumption => ({ timing, failures: count })),
  ).flat();
}

export function sameAssumption(one: Assumption, other: Assumption): boolean {
  return one.timing === other.timing && one.failures === other.failures;
}

export function columnAt(
  assumptions: readonly Assumption[],
  columns: readonly VerifyColumnMessage[],
  place: number,
): VerifyColumnMessage | undefined {
  const wanted = assumptions[place];
  return wanted === undefined ? undefined : columns.find((one) => sameAssumption(one, wanted));
}

/** How an answer is drawn; of a property that has none yet, whether its column is explored now, or will be. */
export function shapeOf(answer: CheckedProperty | undefined, busy: boolean, now: boolean): Shape {
  if (answer === undefined) return !busy ? "none" : now ? "running" : "waits";
  switch (answer.answer) {
    case "holds":
    case "vacuous":
      return answer.answer;
    case "not finished":
      return "cut";
    case "broken":
      return answer.confirmed === null ? "unconfirmed" : "broken";
  }
}

/** A part of a run in words: what happens once, or again and again, and the events that are left out after it. */
export interface Stretch {
  repeats: boolean;
  events: readonly CheckedEvent[];
}

/** A run as what happens at first and what then repeats. */
export function stretches({ events, repeats_from }: CheckedProperty): Stretch[] {
  if (repeats_from < 0) return [{ repeats: false, events }];
  return [
    { repeats: false, events: events.filter(({ step }) => step < repeats_from) },
    { repeats: true, events: events.filter(({ step }) => step >= repeats_from) },
  ];
}
