/** The notes of a vertex as the page shows them. */
import type { Note } from "./types";

/** The lines above an instruction as one text. */
export function noteText(notes: readonly Note[]): string {
  return notes
    .filter((note) => note.at === "")
    .map((note) => note.text)
    .join("\n");
}

/** Notes that stand elsewhere: behind the instruction or at the end of a body. */
export function otherNotes(notes: readonly Note[]): string {
  return notes
    .filter((note) => note.at !== "")
    .map((note) => note.text)
    .join("\n");
}
