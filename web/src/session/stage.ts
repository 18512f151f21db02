/**
 * How much room the arena has, and whether a tutorial is on, in which the arena shows more.
 *
 * `beside`: it has the right column to itself while something runs and after that, until somebody asks for the text;
 * `large`: the program is small beside it. Parts that were selected before the run take nothing of that room; what is selected
 * during it and after it does.
 */
import { create } from "zustand";

import { useStudio } from "../model/studio";
import { readStored, writeStored } from "../ui/browser-storage";

interface Stage {
  large: boolean;
  beside: boolean;
  /** Somebody wants the text beside the arena, whatever runs. */
  text: boolean;
  /** What was selected when the run began. */
  selectedBefore: readonly string[] | null;
  lesson: boolean;
}

const KEY = "kitrobot.text";

export const useStage = create<Stage>(() => ({
  large: false,
  beside: false,
  // Somebody asked for the text in this browser, and did not send it away since.
  text: readStored(KEY) === "yes",
  selectedBefore: null,
  lesson: false,
}));

/** Something runs, or nothing does any more. */
export function setBeside(beside: boolean): void {
  const { selection } = useStudio.getState();
  useStage.setState(({ text }) => ({ beside: beside && !text, selectedBefore: beside ? selection : null }));
}

/** The text comes back beside the arena and stays there, or goes again; this browser remembers which. */
export function toggleText(): void {
  useStage.setState(({ beside }) => ({ beside: !beside, text: beside }));
  writeStored(KEY, useStage.getState().text ? "yes" : "no");
}

export function enlargeStage(large: boolean): void {
  useStage.setState({ large });
}

/** A tutorial begins or ends. */
export function setLesson(lesson: boolean): void {
  useStage.setState({ lesson });
}
