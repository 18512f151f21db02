/** Puts the sheet on the page when the browser is about to print, in its place the rest goes, and takes it away again. */
import { createElement } from "react";
import { flushSync } from "react-dom";
import { createRoot, type Root } from "react-dom/client";

import { UNKNOWN_ICON } from "../../../components/graph/drawn";
import { onPaper } from "../../../components/graph/ink";
import { mirrored } from "../../../i18n/language";
import { type StudioState, useStudio } from "../../../model/studio";
import { text } from "../../../model/texts";
import { fileName, useDocument } from "../../../session/document";
import { loadIcons } from "../../../theme";
import { type PrintChoice, usePrintChoice } from "../choice";
import { PrintSheet } from "./PrintSheet";
import "./sheet.css";

/** What the sheet on the page was made of. */
interface Shown {
  root: Root;
  place: HTMLElement;
  state: StudioState;
  choice: PrintChoice;
  /** The title of the page as it was. */
  title: string;
}

/** A text as CSS has it between quotes. */
function quoted(text: string): string {
  return `"${text.replace(/["\\\n\r\f]/g, (letter) => `\\${letter.charCodeAt(0).toString(16)} `)}"`;
}

function put(): Shown | null {
  if (!useDocument.getState().ready) return null;
  const [state, choice] = [useStudio.getState(), usePrintChoice.getState()];
  const place = document.createElement("main");
  place.className = "print-sheet paper";
  place.dataset["testid"] = "print-sheet";
  document.body.append(place);
  const root = createRoot(place);
  const file = fileName();
  const name = text(state.mission.label ?? {}, file.replace(/\.krt$/i, ""));
  onPaper(() => {
    flushSync(() => {
      root.render(createElement(PrintSheet, { state, choice, title: name, file }));
    });
  });
  // The title stands above each page but the first one, which has it itself.
  const head = document.createElement("style");
  const side = mirrored() ? "@top-right" : "@top-left";
  head.textContent = `@page { ${side} { content: ${quoted(name)}; } } @page :first { ${side} { content: ""; } }`;
  place.append(head);
  const shown = { root, place, state, choice, title: document.title };
  // The name of the file, where the browser saves one.
  document.title = choice.one ? `${name} · ${state.activeProgram}` : name;
  return shown;
}

function take(shown: Shown): void {
  shown.root.unmount();
  shown.place.remove();
  document.title = shown.title;
}

/**
 * From now on whatever prints the page prints the sheet. What it gives opens the browser's print dialog; icons that are not
 * loaded yet are fetched before.
 */
export function keepSheet(): () => Promise<void> {
  let shown: Shown | null = null;
  const putAnew = () => {
    if (shown !== null) take(shown);
    shown = put();
  };
  window.addEventListener("beforeprint", () => {
    const isCurrent = shown?.state === useStudio.getState() && shown.choice === usePrintChoice.getState();
    if (!isCurrent || !shown?.place.isConnected) putAnew();
  });
  window.addEventListener("afterprint", () => {
    if (shown !== null) take(shown);
    shown = null;
  });
  return async () => {
    putAnew();
    if (shown?.place.querySelector(UNKNOWN_ICON) != null) {
      await loadIcons();
      putAnew();
    }
    window.print();
  };
}
