/** Writes the note above a vertex, the one that becomes comment lines above its instruction. */
import { t } from "../../i18n/words";
import { type Command, replaceProgram } from "../command";
import { noteText } from "../notes";
import type { Program } from "../types";

/** The command, or null when the note says that already. An empty text takes the note away. */
export function setNote(program: Program, id: string, text: string): Command | null {
  const vertex = program.vertices.find((one) => one.id === id);
  if (vertex === undefined) return null;
  const before = noteText(vertex.notes);
  if (before === text) return null;
  const others = vertex.notes.filter((note) => note.at !== "");
  const notes = text === "" ? others : [{ text, at: "" }, ...others];
  const vertices = program.vertices.map((one) => (one === vertex ? { ...one, notes } : one));
  return {
    ...replaceProgram(t("command.note"), program, { ...program, vertices }),
    joins: `note ${program.name} ${id}`,
  };
}
