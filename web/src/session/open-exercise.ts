/** Which exercise is open in this browser, and as which mission, kept over a reload; and how far its goals are. */
import { create } from "zustand";
import { parseStored, readStored, writeStored } from "../ui/browser-storage";

const KEY = "kitrobot.exercise";

export interface Remembered {
  name: string;
  /** The mission that is worked on (`workPlace`): where the exercise began, or what it was saved as. */
  path: string;
}

/** What was remembered, as far as it makes sense; null for nothing. */
export function readRemembered(text: string | null): Remembered | null {
  const found = parseStored(text);
  if (typeof found !== "object" || found === null) return null;
  const { name, path } = found as Record<string, unknown>;
  return typeof name === "string" && typeof path === "string" ? { name, path } : null;
}

interface OpenExercise {
  /** What a teacher wrote on exercises, by their names. */
  comments: Readonly<Record<string, string>>;
  open: Remembered | null;
  /** Whether each goal is reached, null where that is not known, and why not. */
  goals: readonly { reached: boolean | null; why: string }[];
  /** Hands in what is open, and says so; null where there is nobody to hand it to. */
  handIn: (() => void) | null;
}

/** Where a mission is worked on: its path, or its name while it has no path. */
export function workPlace({ path, name }: { path: string; name: string }): string {
  return path === "" ? name : path;
}

/** The exercise that is open; the panel, which is fetched later, shows it. */
export const useOpenExercise = create<OpenExercise>(() => ({
  open: readRemembered(readStored(KEY)),
  goals: [],
  comments: {},
  handIn: null,
}));

/** The exercise that is worked on in that file; "" for none. */
export function workedOn(file: { path: string; name: string }): string {
  const { open } = useOpenExercise.getState();
  return open?.path === workPlace(file) ? open.name : "";
}

export function setHandIn(handIn: OpenExercise["handIn"]): void {
  useOpenExercise.setState({ handIn });
}

export function setGoals(goals: OpenExercise["goals"]): void {
  useOpenExercise.setState({ goals });
}

export function setComments(comments: OpenExercise["comments"]): void {
  useOpenExercise.setState({ comments });
}

export function remember(open: Remembered | null): void {
  useOpenExercise.setState({ open });
  writeStored(KEY, open === null ? null : JSON.stringify(open));
}
