/** The map of a sweep as rows of fields, and how one walks in it. */
import type { SweepField, SweepMapMessage } from "../../api/generated";

/** A field, by the places of its robot and of its moment. */
export interface Place {
  agent: number;
  moment: number;
}

export type Ending = SweepField["outcome"] | "none";

/** In the order of the legend; each has a sign, so that it never rests on a hue. */
export const SIGNS: Readonly<Record<Ending, string>> = { done: "✓", failed: "!", stuck: "×", time: "…", none: "" };
export const ENDINGS = Object.keys(SIGNS) as readonly Ending[];

/** Fields by robot, then moment; null where a sweep that was broken off did not come to. */
export function rowsOf({ agents, moments, fields }: SweepMapMessage): (SweepField | null)[][] {
  const rows = agents.map(() => moments.map((): SweepField | null => null));
  for (const field of fields) {
    const row = rows[field.agent];
    if (row !== undefined) row[field.moment] = field;
  }
  return rows;
}

/** How many fields end how. */
export function countsOf({ fields, total }: SweepMapMessage): Record<Ending, number> {
  const counts: Record<Ending, number> = { done: 0, failed: 0, stuck: 0, time: 0, none: total - fields.length };
  for (const { outcome } of fields) counts[outcome] += 1;
  return counts;
}

/** Where a key leads from a field, or null; `forward` is the arrow that points along a line of writing. */
export function walk(
  key: string,
  { agent, moment }: Place,
  size: Place,
  forward: "ArrowRight" | "ArrowLeft",
): Place | null {
  const back = forward === "ArrowRight" ? "ArrowLeft" : "ArrowRight";
  const steps: Record<string, Place> = {
    [forward]: { agent, moment: moment + 1 },
    [back]: { agent, moment: moment - 1 },
    ArrowDown: { agent: agent + 1, moment },
    ArrowUp: { agent: agent - 1, moment },
    Home: { agent, moment: 0 },
    End: { agent, moment: size.moment - 1 },
    PageUp: { agent: 0, moment },
    PageDown: { agent: size.agent - 1, moment },
  };
  const to = steps[key];
  if (to === undefined) return null;
  const within = (value: number, count: number) => Math.min(Math.max(value, 0), count - 1);
  return { agent: within(to.agent, size.agent), moment: within(to.moment, size.moment) };
}
