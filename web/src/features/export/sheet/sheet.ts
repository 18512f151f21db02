/** Puts the sheet on the page when the browser is about to print, in its place the rest goes, and takes it away again. */
import { createElement } from "react";
import { flushSync } from "react-dom";
import { createRoot, type Root } from "react-dom/client";

import { UNKNOWN_ICON } from "../../../components/graph/drawn";
import { onPaper } from "../../../components/graph/ink";
import { type StudioState, useStudio } from "../../../model/studio";
import { text } from "../../../model/texts";
import { fileName, useDocument } from "../../../session/document";
import { loadIcons } from "../../../theme";
import { PrintSheet } from "./PrintSheet";
import "./sheet.css";

let shown: { root: Root; place: HTMLElement; state: StudioState } | null = null;

function put(): void {
  take();
  if (!useDocument.getState().ready) return;
  const state = useStudio.getState();
  const place = document.createElement("main");
  place.className = "print-sheet paper";
  place.dataset["testid"] = "print-sheet";
  document.body.append(place);
  const root = createRoot(place);
  shown = { root, place, state };
  const file = fileName();
  const title = text(state.mission.label ?? {}, file.replace(/\.krt$/i, ""));
  onPaper(() => {
    flushSync(() => {
      root.render(createElement(PrintSheet, { state, title, file }));
    });
  });
}

function take(): void {
  shown?.root.unmount();
  shown?.place.remove();
  shown = null;
}

/** From now on whatever prints the page prints the sheet. */
export function keepSheet(): void {
  window.addEventListener("beforeprint", () => {
    if (shown?.state !== useStudio.getState() || !shown.place.isConnected) put();
  });
  window.addEventListener("afterprint", take);
}

/** Opens the browser's print dialog; icons that are not loaded yet are fetched before. */
export async function print(): Promise<void> {
  put();
  if (shown?.place.querySelector(UNKNOWN_ICON) != null) {
    await loadIcons();
    put();
  }
  window.print();
}
