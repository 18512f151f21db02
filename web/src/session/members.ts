/**
 * Whether the list of members is open: in the place of the watch and of the list of problems, and the other way round;
 * and what changes who is in a team.
 */
import { create } from "zustand";

import type { RunEvent } from "../api/wire";
import { useProblemList } from "./problem-walk";
import { useWatch } from "./watching";

/** What changes who is in a team, or is why. */
export function changesOf(events: readonly RunEvent[]): RunEvent[] {
  return events.filter(({ kind }) => kind === "member" || kind === "failure" || kind === "revival");
}

export const useMembers = create<{ open: boolean }>(() => ({ open: false }));

export function showMembers(open: boolean): void {
  if (open) {
    useWatch.getState().show(false);
    useProblemList.setState({ open: false });
  }
  useMembers.setState({ open });
}

useProblemList.subscribe((list, before) => {
  if (list.open && !before.open) useMembers.setState({ open: false });
});
useWatch.subscribe((watch, before) => {
  if (watch.open && !before.open) useMembers.setState({ open: false });
});
