/** A text that is read, not written: CodeMirror with what `extensions` adds. */
import { EditorState, type Extension } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { useEffect, useRef } from "react";

interface TextViewProps {
  text: string;
  label: string;
  extensions: Extension;
}

export function TextView({ text, label, extensions }: TextViewProps) {
  const place = useRef<HTMLDivElement>(null);
  const view = useRef<EditorView | null>(null);

  useEffect(() => {
    const parent = place.current;
    if (parent === null) return;
    const made = new EditorView({
      parent,
      state: EditorState.create({
        doc: "",
        extensions: [
          EditorState.readOnly.of(true),
          EditorView.lineWrapping,
          EditorView.contentAttributes.of({ "aria-label": label, "aria-readonly": "true", tabindex: "0" }),
          extensions,
        ],
      }),
    });
    view.current = made;
    return () => {
      view.current = null;
      made.destroy();
    };
  }, [label, extensions]);

  useEffect(() => {
    const current = view.current;
    if (current === null || current.state.doc.toString() === text) return;
    const top = current.scrollDOM.scrollTop;
    current.dispatch({ changes: { from: 0, to: current.state.doc.length, insert: text } });
    current.scrollDOM.scrollTop = top;
  }, [text, label, extensions]);

  return <div className="text-view" ref={place} />;
}
