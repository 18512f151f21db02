/**
 * What the code view is made of: colours, the gutter with line numbers and thread tokens, active lines, the box around the
 * selected vertex's text.
 *
 * Active lines and the selected span come from outside as one effect (`setShown`); colours follow from the text alone.
 */
import { type Extension, RangeSetBuilder, StateEffect, StateField } from "@codemirror/state";
import { Decoration, type DecorationSet, EditorView, gutter, GutterMarker } from "@codemirror/view";

import { lllMarks } from "./lll-marks";

export interface Shown {
  /** Line → thread numbers. */
  active: ReadonlyMap<number, number[]>;
  /** Spans of the selected vertices, in offsets. */
  selected: readonly { start: number; end: number }[];
  /** Spans of the vertex under the pointer in the graph. */
  pointed?: readonly { start: number; end: number }[];
}

const NOTHING: Shown = { active: new Map(), selected: [] };

export const setShown = StateEffect.define<Shown>();

const shownField = StateField.define<Shown>({
  create: () => NOTHING,
  update(value, transaction) {
    for (const effect of transaction.effects) if (effect.is(setShown)) return effect.value;
    return transaction.docChanged ? NOTHING : value;
  },
});

function colours(text: string): DecorationSet {
  const builder = new RangeSetBuilder<Decoration>();
  for (const { from, to, look } of lllMarks(text)) builder.add(from, to, Decoration.mark({ class: `lll-${look}` }));
  return builder.finish();
}

const colourField = StateField.define<DecorationSet>({
  create: (state) => colours(state.doc.toString()),
  update: (value, transaction) => (transaction.docChanged ? colours(transaction.newDoc.toString()) : value),
  provide: (field) => EditorView.decorations.from(field),
});

/** Which part of the box a line of the selected span draws. */
function boxPart(line: number, first: number, last: number): string {
  return `line-selected${line === first ? " line-selected-first" : ""}${line === last ? " line-selected-last" : ""}`;
}

const lineField = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(value, transaction) {
    const shown = transaction.state.field(shownField);
    if (transaction.startState.field(shownField, false) === shown) return value;
    const doc = transaction.newDoc;
    const classes = new Map<number, string>();
    for (const line of shown.active.keys()) if (line <= doc.lines) classes.set(line, "line-active");
    for (const { start, end } of shown.pointed ?? []) {
      if (end > doc.length) continue;
      const line = doc.lineAt(start).number;
      classes.set(line, `${classes.get(line) ?? ""} line-pointed`);
    }
    for (const { start, end } of shown.selected) {
      if (end > doc.length) continue;
      const first = doc.lineAt(start).number;
      const last = doc.lineAt(end).number;
      for (let line = first; line <= last; line++) {
        classes.set(line, `${classes.get(line) ?? ""} ${boxPart(line, first, last)}`);
      }
    }
    const builder = new RangeSetBuilder<Decoration>();
    for (const [line, name] of [...classes].sort(([a], [b]) => a - b)) {
      const at = doc.line(line).from;
      builder.add(at, at, Decoration.line({ class: name }));
    }
    return builder.finish();
  },
  provide: (field) => EditorView.decorations.from(field),
});

class Numbered extends GutterMarker {
  readonly line: number;
  readonly threads: string;

  constructor(line: number, threads: string) {
    super();
    this.line = line;
    this.threads = threads;
  }

  override eq(other: GutterMarker): boolean {
    return other instanceof Numbered && other.line === this.line && other.threads === this.threads;
  }

  override toDOM(): Node {
    const box = document.createElement("span");
    if (this.threads === "") {
      box.className = "line-number";
      box.textContent = String(this.line);
    } else {
      box.className = "token token-small rigid";
      box.textContent = this.threads;
    }
    return box;
  }
}

const numbers = gutter({
  class: "code-numbers",
  lineMarker: (view, block) => {
    const line = view.state.doc.lineAt(block.from).number;
    return new Numbered(line, (view.state.field(shownField, false)?.active.get(line) ?? []).join(" "));
  },
  lineMarkerChange: (update) => update.startState.field(shownField, false) !== update.state.field(shownField, false),
  initialSpacer: () => new Numbered(8, ""),
});

/** The gutter alone, for the three-address code. */
export const listingExtensions: Extension = [shownField, numbers];

export const lllExtensions: Extension = [shownField, colourField, lineField, numbers];
