/**
 * Finding in all programs: every word of the query must stand somewhere in what is known of a vertex — its names, its
 * values and conditions in words, its notes, the line of LLL it became.
 */
import { type Parts, title } from "./parts";
import { type Block, readStructure } from "./structure";
import { text } from "./texts";
import { everySpot } from "./tree";
import type { Program, Report, Vertex } from "./types";
import { fieldWords, wordsOf } from "./words";

export interface Hit {
  program: string;
  vertex: string;
  /** The element as it is drawn. */
  name: string;
  /** What else it says: its note when the query is in it, else values and conditions. */
  aside: string;
  shape: Block["shape"];
}

export const MOST_HITS = 200;

/** The first line of LLL of each vertex, as the last check saw it. */
function linesOf(report: Report | null, program: string): Map<string, string> {
  const found = report?.programs.find((one) => one.name === program);
  return new Map(
    found?.spans.map(({ vertex, start, end }) => [vertex, found.lll.slice(start, end).split("\n", 1)[0] ?? ""]),
  );
}

function valuesOf(block: Block): string {
  const { shape } = block;
  const fields = shape.fields.map(({ name, label }) =>
    [text(label, name), fieldWords(block, name)].filter((word) => word !== "").join(" "),
  );
  const conditions = block.plugs.flatMap(({ slot, block: filler }) =>
    filler === null || shape.fields.some((field) => field.name === slot) ? [] : [wordsOf(filler)],
  );
  return [...conditions, ...fields].join(", ");
}

function notesOf({ notes }: Vertex): string {
  return notes.map((note) => note.text).join(" ");
}

/** What the query finds, in reading order, program after program; nothing for an empty query. */
export function findIn(
  programs: readonly Program[],
  partsFor: (robot: string) => Parts,
  report: Report | null,
  query: string,
): Hit[] {
  const wanted = query.trim().toLowerCase().split(/\s+/);
  if (wanted[0] === "") return [];
  const holds = (words: string) => wanted.every((word) => words.toLowerCase().includes(word));
  const hits: Hit[] = [];
  for (const program of programs) {
    const lines = linesOf(report, program.name);
    everySpot(readStructure(program, partsFor(program.robot)), ({ block }) => {
      const { vertex, shape } = block;
      const own = shape.role === "condition" || shape.role === "value" ? wordsOf(block) : "";
      const said = valuesOf(block);
      const notes = notesOf(vertex);
      const all = [title(shape), vertex.element, own, said, notes, lines.get(vertex.id) ?? ""].join("\n");
      if (hits.length >= MOST_HITS || !holds(all)) return;
      const noted = notes !== "" && wanted.some((word) => notes.toLowerCase().includes(word));
      hits.push({
        program: program.name,
        vertex: vertex.id,
        name: own === "" ? title(shape) : own,
        aside: noted ? notes : own === "" ? said : "",
        shape,
      });
    });
  }
  return hits;
}
