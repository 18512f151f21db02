/**
 * What the whole page knows of real robots: whether their panel is open, and a way to STOP them. The rest (`boards.ts` and what
 * it shows) is fetched when somebody first wants a robot; most never do.
 */
import { create } from "zustand";

import { openRoom } from "../../session/narrow";
import { useLayout } from "../../session/layout";

interface Robots {
  /** The panel stands in the place of the arena. */
  open: boolean;
  /** How many robots run, whoever began it; STOP is for them too. */
  running: number;
  /** Stops every robot; null until there was one to talk with. */
  stopAll: (() => void) | null;
}

export const useRobotsPanel = create<Robots>(() => ({ open: false, running: 0, stopAll: null }));

/** So many robots run, of those whose state is shown. */
export function setRunning(running: number): void {
  useRobotsPanel.setState({ running });
}

/** How STOP reaches the robots, once the page talks with them. */
export function setStopAll(stopAll: Robots["stopAll"]): void {
  useRobotsPanel.setState({ stopAll });
}

export function showRobots(open = true): void {
  const { folded, toggle } = useLayout.getState();
  // It stands where the arena does; that may have been folded away.
  if (open && folded.arena) toggle("arena");
  // On a phone one room is open at a time.
  if (open) openRoom("arena");
  useRobotsPanel.setState({ open });
}
