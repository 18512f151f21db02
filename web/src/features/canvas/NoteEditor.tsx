/** The note of a vertex while it is written, over the vertex. */
import "./note-editor.css";

import { useEffect, useLayoutEffect, useRef, useState } from "react";

import { t } from "../../i18n/words";
import { noteText } from "../../model/notes";
import { programInView, useStudio } from "../../model/studio";
import { currentDrawing, nodeOf } from "../../session/drawing";
import { closeNote, useView } from "../../session/view";
import { notesOf, write } from "./Notes";

const WIDTH = 336;

export function NoteEditor({ id, program }: { id: string; program: string }) {
  const [before] = useState(() => noteText(notesOf(programInView(useStudio.getState()), id)));
  const [text, setText] = useState(before);
  const [at] = useState(() => placeOf(id));
  const field = useRef<HTMLTextAreaElement>(null);
  const latest = useRef({ text, forget: false });
  useEffect(() => {
    latest.current.text = text;
  });

  // Whichever way the field goes (Enter, a click elsewhere, another program), what was typed is kept.
  useEffect(() => {
    const now = latest.current;
    now.forget = false;
    field.current?.focus({ preventScroll: true });
    field.current?.setSelectionRange(now.text.length, now.text.length);
    return () => {
      if (!now.forget) write(id, now.text, program);
    };
  }, [id, program]);
  useLayoutEffect(() => {
    const element = field.current;
    if (element === null) return;
    element.style.height = "0";
    element.style.height = `${String(Math.min(element.scrollHeight, 200))}px`;
  }, [text]);

  const close = () => {
    closeNote();
    useView.getState().viewport?.focus();
  };
  return (
    <div
      className="note-editor surface"
      style={{ width: WIDTH, "--x": `${String(at.x)}px`, "--y": `${String(at.y)}px` } as React.CSSProperties}
    >
      <textarea
        ref={field}
        rows={1}
        dir="auto"
        data-testid="note-field"
        aria-label={t("inspector.note")}
        aria-describedby="note-keys"
        placeholder={t("inspector.note-hint")}
        value={text}
        onChange={(event) => setText(event.target.value)}
        onBlur={() => closeNote()}
        onKeyDown={(event) => {
          if (event.nativeEvent.isComposing) return;
          if (event.key === "Escape") latest.current.forget = true;
          if (event.key === "Escape" || (event.key === "Enter" && !event.shiftKey)) {
            event.preventDefault();
            event.stopPropagation();
            close();
          }
        }}
      />
      <p id="note-keys">{t("graph.note-keys")}</p>
    </div>
  );
}

/** The bottom edge of the editor stands on the vertex. */
function placeOf(id: string): { x: number; y: number } {
  const drawing = currentDrawing();
  const node = drawing === null ? undefined : nodeOf(drawing, id);
  const { viewport } = useView.getState();
  if (node === undefined || viewport === null) return { x: 0, y: 0 };
  return viewport.place({ x: node.x + node.w / 2, y: node.y });
}
