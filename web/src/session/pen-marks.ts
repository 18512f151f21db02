/** What the pens of a run drew, as the server tells it: a list that grows at its end and is cut when the run goes back. */
import { create } from "zustand";

import type { Drawing, RunMessage } from "../api/wire";

export type PenMark = Drawing["marks"][number];

interface Drawn {
  marks: readonly PenMark[];
  /** Of each pen the place of its robot among the agents. */
  pens: readonly number[];
}

const NOTHING: Drawn = { marks: [], pens: [] };
const usePens = create(() => NOTHING);

export function drawnByPens(): Drawn {
  return usePens.getState();
}

export function drawnAfter(before: Drawn, message: RunMessage): Drawn {
  if (message.type === "started") return { marks: [], pens: message.pens };
  if (message.type !== "tick" || message.drawing === null) return before;
  const { keep, marks } = message.drawing;
  return { ...before, marks: [...before.marks.slice(0, keep), ...marks] };
}

export function takeMarks(message: RunMessage): void {
  usePens.setState((drawn) => drawnAfter(drawn, message));
}

export function forgetMarks(): void {
  usePens.setState(NOTHING);
}
