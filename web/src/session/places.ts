/**
 * Places as the server counts them (whole characters, lines and columns from 1) and as the page does (UTF-16 units from 0).
 */
import type { Problem, SpanEntry } from "../model/types";

const PAIRS = /[\ud800-\udbff][\udc00-\udfff]/g;

/** From whole characters to units, for one text. */
export function unitsOf(text: string): (characters: number) => number {
  const pairs: number[] = [];
  for (const match of text.matchAll(PAIRS)) pairs.push(match.index - pairs.length);
  if (pairs.length === 0) return (characters) => characters;
  return (characters) => characters + pairs.filter((at) => at < characters).length;
}

export function spansInUnits<Span extends SpanEntry>(spans: readonly Span[], text: string): readonly Span[] {
  if (text.search(PAIRS) < 0) return spans;
  const units = unitsOf(text);
  return spans.map((span) => ({ ...span, start: units(span.start), end: units(span.end) }));
}

export interface Stretch {
  from: number;
  to: number;
}

/** Where a problem stands in a text; empty where something is missing. */
export function exactStretchOf(problem: Problem, text: string): Stretch {
  const lines = text.split("\n");
  const offset = (line: number, column: number): number => {
    const at = Math.min(Math.max(line, 1), lines.length) - 1;
    const before = lines.slice(0, at).reduce((sum, one) => sum + one.length + 1, 0);
    const own = line > lines.length ? Infinity : column - 1;
    const words = lines[at] ?? "";
    return before + Math.min(unitsOf(words)(own), words.length);
  };
  const from = offset(problem.line, problem.column);
  return { from, to: Math.max(offset(problem.end_line, problem.end_column), from) };
}

/** As `exactStretchOf`, at least one character of the text where there is one: what can be marked. */
export function stretchOf(problem: Problem, text: string): Stretch {
  const { from, to } = exactStretchOf(problem, text);
  if (to > from) return { from, to };
  return from > 0 && (from === text.length || text[from] === "\n") && text[from - 1] !== "\n"
    ? { from: from - 1, to: from }
    : { from, to: Math.min(from + 1, text.length) };
}
