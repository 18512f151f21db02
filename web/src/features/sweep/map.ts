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
