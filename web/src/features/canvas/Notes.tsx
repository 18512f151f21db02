/**
 * Notes on the canvas: a strip on the top edge of a vertex shows the first line; a click or N opens the whole note to be
 * read and edited in its place. What was typed is kept when the field is left, as one step that can be undone.
 */
import { t } from "../../i18n/words";
import { setNote } from "../../model/commands/setNote";
import type { LayoutNode } from "../../model/layout";
import { noteText } from "../../model/notes";
import { programInView, useStudio } from "../../model/studio";
import type { Program } from "../../model/types";
import { currentDrawing, nodeOf } from "../../session/drawing";
import { holdingStill, showNote, useView } from "../../session/view";
import { Icon } from "../../theme";

/** The vertex whose note is meant: the mark around an action where that one has the note, else what is shown. */
function ownerOf(id: string): string {
  const drawing = currentDrawing();
  const node = drawing === null ? undefined : nodeOf(drawing, id);
  const { block = null, mark = null, vertex = id } = node ?? {};
  if (mark !== null && block !== null && noteText(block.vertex.notes) === "" && noteText(mark.vertex.notes) !== "")
    return mark.vertex.id;
  return vertex;
}

/** Opens the note of the selected vertex; Start has none, the others can have one. */
export function openNote(id: string | undefined = useStudio.getState().selection.at(-1)): boolean {
  const start = currentDrawing()?.structure.start?.id;
  if (id === undefined || id === start) return false;
  useView.getState().viewport?.reveal(id);
  showNote(ownerOf(id));
  return true;
}

/** Whether the selected vertex has a note, for menus. */
export function isNoted(id: string): boolean {
  return noteText(notesOf(programInView(useStudio.getState()), ownerOf(id))) !== "";
}

export function removeNote(): boolean {
  const id = useStudio.getState().selection.at(-1);
  return id !== undefined && write(ownerOf(id), "");
}

export function notesOf(program: Program | undefined, id: string) {
  return program?.vertices.find((one) => one.id === id)?.notes ?? [];
}

export function write(id: string, text: string, name = useStudio.getState().activeProgram): boolean {
  const { mission, execute } = useStudio.getState();
  const program = mission.programs.find((one) => one.name === name);
  const command = program === undefined ? null : setNote(program, id, text.trimEnd());
  if (command === null) return false;
  // Two notes that are written one after the other are two steps.
  execute({ ...command, joins: `note ${String(performance.now())}` });
  return true;
}

/** The strip above a vertex: one line of the note, whatever its script; more of it is behind the dots. */
export function NoteStrip({ node: { note, noteWidth, w, vertex } }: { node: LayoutNode }) {
  if (note === "") return null;
  const [first = "", ...more] = note.split("\n");
  return (
    <button
      type="button"
      className="note-strip row muted start-text nowrap gap-s"
      data-testid={`note-${vertex}`}
      dir="auto"
      title={note}
      aria-label={t("graph.note", { text: note })}
      tabIndex={-1}
      style={{ width: noteWidth, insetInlineStart: (w - noteWidth) / 2 }}
      onPointerDown={(event) => event.stopPropagation()}
      onClick={(event) => {
        event.stopPropagation();
        holdingStill(() => {
          useStudio.getState().select([vertex]);
        });
        showNote(vertex);
      }}
    >
      <Icon name="message-circle" size={12} />
      <span className="note-words grow">{first}</span>
      {more.length === 0 ? null : (
        <span className="rigid tiny-text">{t("graph.note-more", { count: more.length })}</span>
      )}
    </button>
  );
}
