/** A text that is read, not written: CodeMirror with what `extensions` adds. */
import { EditorState, type Extension } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { useEffect, useRef } from "react";

import { setShown, type Shown } from "./extensions";

interface TextViewProps {
  text: string;
  label: string;
  extensions: Extension;
  /** What is marked in it; `extensions` have to hold how. */
  shown?: Shown;
  /** The caret was put somewhere, by the mouse or by keys; an offset. */
  onPick?: (offset: number, byMouse: boolean) => void;
}

export function TextView({ text, label, extensions, shown, onPick }: TextViewProps) {
  const place = useRef<HTMLDivElement>(null);
  const view = useRef<EditorView | null>(null);
  const pick = useRef(onPick);
  useEffect(() => {
    pick.current = onPick;
  });

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
          EditorView.updateListener.of(({ transactions, state }) => {
            if (!transactions.some((one) => one.isUserEvent("select"))) return;
            const byMouse = transactions.some((one) => one.isUserEvent("select.pointer"));
            pick.current?.(state.selection.main.head, byMouse);
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
    if (shown !== undefined) view.current?.dispatch({ effects: setShown.of(shown) });
  }, [shown, text, label, extensions]);

  // What is selected elsewhere comes into view.
  const first = shown?.selected[0]?.start;
  useEffect(() => {
    const current = view.current;
    if (first === undefined || current === null || current.hasFocus || first > current.state.doc.length) return;
    current.dispatch({ effects: EditorView.scrollIntoView(first, { y: "nearest", yMargin: 20 }) });
  }, [first, text, label, extensions]);

  return <div className="text-view" ref={place} />;
}
