/** A text that is read, not written: CodeMirror with what `extensions` adds. */
import { EditorState, type Extension } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { useEffect, useRef } from "react";

import { setShown, type Shown } from "./extensions";

interface TextViewProps {
  text: string;
  label: string;
  extensions: Extension;
  shown?: Shown;
  /** The person put the caret here, by mouse or by keyboard. */
  onPick?: (offset: number, byMouse: boolean) => void;
}

export function TextView({ text, label, extensions, shown, onPick }: TextViewProps) {
  const place = useRef<HTMLDivElement>(null);
  const view = useRef<EditorView | null>(null);
  const pick = useRef(onPick);
  useEffect(() => {
    pick.current = onPick;
  }, [onPick]);

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
          EditorView.updateListener.of((update) => {
            if (update.docChanged || !update.selectionSet) return;
            const byMouse = update.transactions.some((one) => one.isUserEvent("select.pointer"));
            const byHand = update.transactions.some((one) => one.isUserEvent("select"));
            const range = update.state.selection.main;
            if (byHand && range.empty) pick.current?.(range.head, byMouse);
          }),
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

  useEffect(() => {
    const current = view.current;
    if (current === null || shown === undefined) return;
    current.dispatch({ effects: setShown.of(shown) });
  }, [shown, text, label, extensions]);

  const first = shown?.selected[0]?.start;
  useEffect(() => {
    const current = view.current;
    if (current === null || first === undefined || first > current.state.doc.length || current.hasFocus) return;
    current.dispatch({ effects: EditorView.scrollIntoView(first, { y: "nearest", yMargin: 24 }) });
  }, [first, text]);

  return <div className="text-view" ref={place} />;
}
