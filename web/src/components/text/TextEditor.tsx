/**
 * A program's LLL in CodeMirror: read at once, written as soon as the editing part is there. That is fetched when a pointer
 * or the focus comes to the text, or a mistake is to be marked in it; keys that are pressed meanwhile are typed then.
 *
 * The text in it is `text` whenever that changes from outside, changed in the smallest stretch, so caret and scroll stay; what
 * the person types goes out by `onType` first and comes back as `text`.
 */
import { Annotation, Compartment, EditorState, type Extension } from "@codemirror/state";
import { EditorView, placeholder } from "@codemirror/view";
import { useEffect, useRef, useState } from "react";

import { t } from "../../i18n/words";
import type { Problem } from "../../model/types";
import { reportError } from "../../session/document";
import { holdKeys } from "../../ui/held-keys";
import type * as Editing from "./editing";
import { lllExtensions, setShown, type Shown } from "./extensions";

interface TextEditorProps {
  text: string;
  label: string;
  empty: string;
  shown: Shown;
  /** Mistakes with their places in `text`; null until they are checked. */
  problems: readonly Problem[] | null;
  /** Whether the graph shows this very text. */
  settled: boolean;
  around: Editing.Surroundings;
  /** It is there to be written: the editing part is fetched at once. */
  writes?: boolean;
  onType: (text: string, before: string) => void;
  onFocus: (on: boolean) => void;
  onPick: (offset: number, byMouse: boolean) => void;
  onPoint: (offset: number | null) => void;
}

const fromOutside = Annotation.define<boolean>();
/** What makes the text one that can be written, once it is there. */
const writing = new Compartment();
const READ_ONLY: Extension = [
  EditorState.readOnly.of(true),
  EditorView.contentAttributes.of({ "aria-readonly": "true" }),
];

/** The smallest stretch whose replacement makes one text the other. */
export function changeBetween(before: string, after: string): { from: number; to: number; insert: string } {
  const most = Math.min(before.length, after.length);
  let from = 0;
  while (from < most && before[from] === after[from]) from++;
  let tail = 0;
  while (tail < most - from && before[before.length - 1 - tail] === after[after.length - 1 - tail]) tail++;
  return { from, to: before.length - tail, insert: after.slice(from, after.length - tail) };
}

export function TextEditor(props: TextEditorProps) {
  const { text, label, empty, shown, problems, settled } = props;
  const place = useRef<HTMLDivElement>(null);
  const [view, setView] = useState<EditorView | null>(null);
  const [editing, setEditing] = useState<typeof Editing | null>(null);
  const [touched, setTouched] = useState(props.writes === true);
  const held = useRef<((give: boolean) => void) | null>(null);
  const latest = useRef(props);
  useEffect(() => {
    latest.current = props;
  });

  const releaseKeys = (give: boolean) => {
    held.current?.(give);
    held.current = null;
  };
  useEffect(() => () => releaseKeys(false), []);

  const wanted = touched || (problems !== null && problems.length > 0);
  useEffect(() => {
    if (!wanted) return;
    let there = true;
    import("./editing").then(
      (loaded) => {
        if (there) setEditing(loaded);
      },
      () => {
        releaseKeys(false);
        if (!there) return;
        // The next touch tries again.
        setTouched(false);
        reportError(new Error(t("error.offline")));
      },
    );
    return () => {
      there = false;
    };
  }, [wanted]);

  useEffect(() => {
    const parent = place.current;
    if (parent === null) return;
    const made = new EditorView({
      parent,
      state: EditorState.create({
        doc: latest.current.text,
        extensions: [
          writing.of(READ_ONLY),
          placeholder(empty),
          EditorView.lineWrapping,
          EditorView.contentAttributes.of({
            "aria-label": label,
            "aria-describedby": "code-state",
            tabindex: "0",
          }),
          EditorView.updateListener.of((update) => {
            if (update.focusChanged) latest.current.onFocus(update.view.hasFocus);
            if (update.docChanged) {
              const own = update.transactions.every((one) => one.annotation(fromOutside) !== true);
              if (own) latest.current.onType(update.state.doc.toString(), update.startState.doc.toString());
              return;
            }
            if (!update.selectionSet) return;
            const byMouse = update.transactions.some((one) => one.isUserEvent("select.pointer"));
            const byHand = update.transactions.some((one) => one.isUserEvent("select"));
            const range = update.state.selection.main;
            if (byHand && range.empty) latest.current.onPick(range.head, byMouse);
          }),
          EditorView.domEventHandlers({
            pointermove: (event, at) => latest.current.onPoint(at.posAtCoords({ x: event.clientX, y: event.clientY })),
            pointerleave: () => latest.current.onPoint(null),
          }),
          lllExtensions,
        ],
      }),
    });
    parent.dataset["writable"] = "false";
    setView(made);
    return () => {
      setView(null);
      if (made.hasFocus) latest.current.onFocus(false);
      latest.current.onPoint(null);
      made.destroy();
    };
  }, [label, empty]);

  useEffect(() => {
    if (view === null || editing === null) return;
    const extensions = editing.editingExtensions({
      program: latest.current.around.program,
      parts: () => latest.current.around.parts(),
      elementAt: (offset) => latest.current.around.elementAt(offset),
    });
    // A view that has the focus meanwhile keeps it, and its caret.
    view.dispatch({ effects: writing.reconfigure(extensions) });
    if (place.current !== null) place.current.dataset["writable"] = "true";
    releaseKeys(true);
  }, [view, editing]);

  useEffect(() => {
    if (view === null) return;
    const before = view.state.doc.toString();
    if (before === text) return;
    const top = view.scrollDOM.scrollTop;
    view.dispatch({ changes: changeBetween(before, text), annotations: fromOutside.of(true) });
    view.scrollDOM.scrollTo({ top });
  }, [text, view]);

  useEffect(() => {
    if (settled && view !== null && editing !== null) editing.forget(view);
  }, [settled, text, view, editing]);

  useEffect(() => {
    view?.dispatch({ effects: setShown.of(shown) });
  }, [shown, text, view]);

  useEffect(() => {
    if (view !== null && editing !== null && problems !== null) editing.mark(view, problems);
  }, [problems, text, view, editing]);

  const first = shown.selected[0]?.start;
  useEffect(() => {
    if (view === null || first === undefined || first > view.state.doc.length || view.hasFocus) return;
    view.dispatch({ effects: EditorView.scrollIntoView(first, { y: "nearest", yMargin: 24 }) });
  }, [first, text, view]);

  return (
    <div
      className="text-view"
      ref={place}
      data-testid="code-editor"
      data-writable="false"
      onPointerEnter={() => setTouched(true)}
      onFocus={() => {
        setTouched(true);
        if (editing === null) held.current ??= holdKeys();
      }}
      onBlur={() => releaseKeys(false)}
    />
  );
}
