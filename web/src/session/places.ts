/**
 * Places as the server counts them (whole characters, lines and columns from 1) and as the page does (UTF-16 units from 0).
 */
import type { Problem, SpanEntry } from "../model/types";

export function spansInUnits<Span extends SpanEntry>(spans: readonly Span[], text: string): readonly Span[] {
  if (text.search(PAIRS) < 0) return spans;
  const units = unitsOf(text);
  return spans.map((span) => ({ ...span, start: units(span.start), end: units(span.end) }));
}

export interface Stretch {
  from: number;
  to: number;
}

/** Where problems stand in a text; empty where something is missing. */
export function exactStretchesIn(text: string): (problem: Problem) => Stretch {
  const lines = text.split("\n");
  let end = 0;
  const begins = lines.map((line) => (end += line.length + 1) - line.length - 1);
  const offset = (line: number, column: number): number => {
    const at = Math.min(Math.max(line, 1), lines.length) - 1;
    const own = line > lines.length ? Infinity : column - 1;
    const words = lines[at] ?? "";
    return (begins[at] ?? 0) + Math.min(unitsOf(words)(own), words.length);
  };
  return (problem) => {
    const from = offset(problem.line, problem.column);
    return { from, to: Math.max(offset(problem.end_line, problem.end_column), from) };
  };
}

/** As `exactStretchesIn`, at least one character of the text where there is one: what can be marked. */
export function stretchesIn(text: string): (problem: Problem) => Stretch {
  const exact = exactStretchesIn(text);
  return (problem) => {
    const { from, to } = exact(problem);
    if (to > from) return { from, to };
    return from > 0 && (from === text.length || text[from] === "\n") && text[from - 1] !== "\n"
      ? { from: from - 1, to: from }
      : { from, to: Math.min(from + 1, text.length) };
  };
}

/** Characters as the server counts them (whole ones) and as the page does (UTF-16 units). */
const PAIRS = /[\ud800-\udbff][\udc00-\udfff]/g;

/** From whole characters to units, for one text. */
function unitsOf(text: string): (characters: number) => number {
  const pairs: number[] = [];
  for (const match of text.matchAll(PAIRS)) pairs.push(match.index - pairs.length);
  if (pairs.length === 0) return (characters) => characters;
  return (characters) => characters + pairs.filter((at) => at < characters).length;
}
