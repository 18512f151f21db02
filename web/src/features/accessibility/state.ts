/** Whether the outline is open, and the part whose help is open. */
import { create } from "zustand";

import { programInView, useStudio } from "../../model/studio";

interface AccessibilityState {
  outline: boolean;
  /** The element that is explained: a constructor's name or "Object.Method"; "" says how to ask. Null: closed. */
  explained: string | null;
}

export const useAccessibility = create<AccessibilityState>(() => ({ outline: false, explained: null }));

export function toggleOutline(): void {
  useAccessibility.setState(({ outline }) => ({ outline: !outline }));
}

export function closeOutline(): void {
  useAccessibility.setState({ outline: false });
}

/** Explains the entry of the palette that has the focus, else the selected vertex. */
export function explain(): void {
  const row = document.activeElement?.closest<HTMLElement>('[data-testid^="part-"]:not(input)')?.dataset["testid"];
  const state = useStudio.getState();
  const last = state.selection.at(-1);
  const selected = programInView(state)?.vertices.find((vertex) => vertex.id === last)?.element;
  useAccessibility.setState({ explained: row?.replace(/^part-/, "") ?? selected ?? "" });
}

export function closeHelp(): void {
  useAccessibility.setState({ explained: null });
}
