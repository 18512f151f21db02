/**
 * A piece of a program on its own: what is copied, what a pasted text became. It travels as a program without Start and
 * Stop whose blocks hang on nothing, or as a whole one, whose chain it is.
 */
import { lllOf } from "./lll";
import type { Parts } from "./parts";
import { type Block, readStructure, type Structure, writeStructure } from "./structure";
import { topmost, withMark } from "./tree";
import type { Program } from "./types";

export interface Copied {
  program: Program;
  lll: string;
}

/** The given vertices with all they hold, or null when nothing of it can be copied. */
export function copyOf(structure: Structure, ids: readonly string[]): Copied | null {
  const blocks = topmost(structure, [...ids]).map((spot) => withMark(spot).block);
  if (blocks.length === 0) return null;
  const parked = blocks.map((block) => [block]);
  const main = { out: "next", chain: [], closed: false };
  const alone = { ...structure, start: null, stop: null, main, parked, strays: [], lost: [] };
  return { program: writeStructure(alone), lll: lllOf(blocks) };
}

/** The blocks of a piece, in order; ids are still those of the piece. */
export function blocksOf(piece: Program, parts: Parts): Block[] {
  const { main, parked } = readStructure(piece, parts);
  return [...main.chain, ...parked.flat()];
}

/** The piece that a text holds as JSON, or null when it is none: clipboards hold anything. */
export function readPiece(json: string): Program | null {
  let found: unknown;
  try {
    found = JSON.parse(json);
  } catch {
    return null;
  }
  return isPiece(found) ? found : null;
}

type Plain = Record<string, unknown>;

function isPlain(value: unknown): value is Plain {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function holdsTexts(value: unknown, ...names: string[]): value is Plain {
  return isPlain(value) && names.every((name) => typeof value[name] === "string");
}

function isPiece(value: unknown): value is Program {
  if (!holdsTexts(value, "name", "robot") || !Array.isArray(value["vertices"]) || !Array.isArray(value["arcs"]))
    return false;
  return (
    value["arcs"].every((arc) => holdsTexts(arc, "source", "target", "out", "at")) &&
    value["vertices"].every(
      (vertex) =>
        holdsTexts(vertex, "id", "element") &&
        isPlain(vertex["settings"]) &&
        Object.values(vertex["settings"]).every((setting) => typeof setting === "string") &&
        Array.isArray(vertex["notes"]) &&
        vertex["notes"].every((note) => holdsTexts(note, "text", "at")),
    )
  );
}
