/**
 * The keys that hold everywhere on the page. A key that an editor, a field or an open menu has used is left alone.
 */
import { useEffect } from "react";

import { useStudio } from "../model/studio";
import { printSheet } from "../out/print";
import { fixProblem, walkProblems } from "../problems/walk";
import { useRun } from "../run/run";
import { pause, run } from "./actions";
import { newMission, save, show, useDocument } from "./document";

function typing(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLElement &&
    (target.isContentEditable || target.matches("input:not([type=range]), textarea, select"))
  );
}

/** What a key means here, or null. */
export function keyMeaning(event: KeyboardEvent): (() => void) | null {
  const control = event.ctrlKey || event.metaKey;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (key === "F5") return event.shiftKey ? () => useRun.getState().stop() : run;
  if (key === "F6") return pause;
  if (key === "F8") return () => walkProblems(event.shiftKey ? -1 : 1);
  if (control && key === ".") return fixProblem;
  if (key === "F10" && !event.shiftKey) return () => useRun.getState().step();
  if (control && key === "s") return event.shiftKey ? () => show("save-as") : () => void save();
  if (control && key === "p" && !event.shiftKey) return printSheet;
  if (control && key === "o") return () => show("open");
  if (control && event.altKey && key === "n") return newMission;
  if (typing(event.target)) return null;
  if (control && key === "z") return event.shiftKey ? useStudio.getState().redo : useStudio.getState().undo;
  if (control && key === "y") return useStudio.getState().redo;
  if (key === "?" && !control) return () => show("shortcuts");
  if (key === "Escape" && useDocument.getState().overlay !== null) return () => show(null);
  return null;
}

export function useKeys(): void {
  useEffect(() => {
    const onKeyDown = (event: KeyboardEvent) => {
      if (event.defaultPrevented) return;
      const meaning = keyMeaning(event);
      if (meaning === null) return;
      event.preventDefault();
      meaning();
    };
    window.addEventListener("keydown", onKeyDown);
    return () => window.removeEventListener("keydown", onKeyDown);
  }, []);
}
