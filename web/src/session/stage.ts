/** Whether the arena is large and the program small beside it, and whether a tutorial is on, in which the arena shows more. */
import { create } from "zustand";

export const useStage = create<{ large: boolean; lesson: boolean }>(() => ({ large: false, lesson: false }));

export function enlargeStage(large: boolean): void {
  useStage.setState({ large });
}

/** A tutorial begins or ends. */
export function setLesson(lesson: boolean): void {
  useStage.setState({ lesson });
}
