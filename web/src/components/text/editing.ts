/**
 * What makes the code view an editor: keys, undo of what is unfinished, completion, marks of mistakes, help under the pointer.
 *
 * Loaded after the first picture. CodeMirror's own history holds only what was typed since the graph followed last: before
 * that, undo is the studio's, for text and graph together.
 */
import { autocompletion, completionKeymap } from "@codemirror/autocomplete";
import { history, redo, redoDepth, standardKeymap, undo, undoDepth } from "@codemirror/commands";
import { indentUnit } from "@codemirror/language";
import { type Diagnostic, setDiagnostics } from "@codemirror/lint";
import { Compartment, type Extension, Prec } from "@codemirror/state";
import type { EditorView } from "@codemirror/view";
import { hoverTooltip, keymap } from "@codemirror/view";

import { moreWords, sentence, t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { partsOf } from "../../model/parts";
import type { Catalogue, Problem, Robot } from "../../model/types";
import { applyFix } from "../../session/fixes";
import { stretchesIn } from "../../session/places";
import { isUnfinished } from "../../session/typing";
import { completionSource } from "./completion";
import { callHelp, constructHelp, numberHelp } from "./help";
import type { TeamNames } from "./team-names";

export interface Surroundings {
  program: string;
  /** Parts, and what a team's text can name, as they are now. */
  parts: () => { robot: Robot | undefined; catalogue: Catalogue; names?: TeamNames };
  /** The element of the innermost vertex at an offset. */
  elementAt: (offset: number) => string | null;
}

const past = new Compartment();

/** Clears the editor's own undo history. */
export function forget(view: EditorView): void {
  view.dispatch({ effects: past.reconfigure([]) });
  view.dispatch({ effects: past.reconfigure(history()) });
}

function takeBack(program: string) {
  return (view: EditorView): boolean => {
    if (!isUnfinished(program) || undoDepth(view.state) === 0) useStudio.getState().undo();
    else undo(view);
    return true;
  };
}

function doAgain(view: EditorView): boolean {
  if (redoDepth(view.state) === 0) useStudio.getState().redo();
  else redo(view);
  return true;
}

function help({ parts, elementAt }: Surroundings): Extension {
  return hoverTooltip(async (view, pos) => {
    await moreWords();
    const { robot, catalogue } = parts();
    const line = view.state.doc.lineAt(pos);
    const at = pos - line.from;
    const around = elementAt(pos);
    const shape = around === null ? null : partsOf(catalogue, robot?.name ?? "").shape(around);
    const called = numberHelp(line.text, at, shape) ?? callHelp(line.text, at, robot);
    const element = called === null && /\S/.test(view.state.sliceDoc(pos, pos + 1)) ? around : null;
    const words = called ?? (element === null ? null : constructHelp(catalogue, element));
    if (words === null) return null;
    const from = called === null ? pos : line.from + called.from;
    const end = called === null ? pos + 1 : line.from + called.to;
    return {
      pos: from,
      end,
      above: true,
      create: () => {
        const dom = document.createElement("div");
        dom.className = "code-help";
        const add = (tag: string, text: string) => {
          const part = document.createElement(tag);
          part.textContent = text;
          dom.append(part);
        };
        add("strong", words.title);
        for (const parameter of words.parameters) add("div", parameter);
        if (words.help !== "") add("p", words.help);
        return { dom };
      },
    };
  });
}

export function editingExtensions(around: Surroundings): Extension {
  const back = takeBack(around.program);
  return [
    past.of(history()),
    indentUnit.of("  "),
    Prec.high(
      keymap.of([
        { key: "Mod-z", run: back, preventDefault: true },
        { key: "Mod-y", run: doAgain, preventDefault: true },
        { key: "Mod-Shift-z", run: doAgain, preventDefault: true },
      ]),
    ),
    autocompletion({
      override: [completionSource(around.parts)],
      icons: false,
      defaultKeymap: false,
      optionClass: (option) => `option-${option.type ?? "object"}`,
    }),
    Prec.highest(keymap.of(completionKeymap)),
    keymap.of(standardKeymap),
    help(around),
  ];
}

/** Marks the mistakes in the text. */
export function mark(view: EditorView, problems: readonly Problem[]): void {
  const text = view.state.doc.toString();
  const stretchOf = stretchesIn(text);
  const marks = problems.map((problem): Diagnostic => {
    const message = [sentence(problem.message), sentence(problem.help)].filter((one) => one !== "").join("\n");
    const actions = problem.fix == null ? [] : [{ name: t("problems.fix"), apply: () => void applyFix(problem) }];
    const severity = problem.severity === "hint" ? "info" : problem.severity;
    return { ...stretchOf(problem), severity, message, actions };
  });
  view.dispatch(setDiagnostics(view.state, marks));
}
