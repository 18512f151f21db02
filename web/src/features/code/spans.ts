/** Between places of a text and vertices of the graph, by the spans that the server sends with the text. */
import type { SpanEntry } from "../../model/types";

/** The innermost vertex whose text holds an offset; null where none does. */
export function vertexAt(spans: readonly SpanEntry[], offset: number): string | null {
  let best: SpanEntry | null = null;
  for (const span of spans) {
    if (offset < span.start || offset > span.end) continue;
    if (best === null || span.end - span.start < best.end - best.start) best = span;
  }
  return best?.vertex ?? null;
}

/** The vertex whose line it is: the one whose text begins first on it, else the one around its first character. */
export function vertexOfLine(spans: readonly SpanEntry[], line: number, firstCharacter: number): string | null {
  let best: SpanEntry | null = null;
  for (const span of spans) {
    if (span.line === line && (best === null || span.start < best.start)) best = span;
  }
  return best?.vertex ?? vertexAt(spans, firstCharacter);
}

/** Line → threads that stand on it. */
export function activeLines(spans: readonly SpanEntry[], active: ReadonlyMap<string, number[]>): Map<number, number[]> {
  const lines = new Map<number, number[]>();
  for (const { vertex, line } of spans) {
    const slots = active.get(vertex);
    if (slots === undefined) continue;
    lines.set(
      line,
      [...new Set([...(lines.get(line) ?? []), ...slots])].sort((a, b) => a - b),
    );
  }
  return lines;
}
