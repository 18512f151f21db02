/** Which panel is open below the graph: one, or none. A feature names its panels (`docks` of `Feature`). */
import { create } from "zustand";

export const useDock = create<{ open: string | null }>(() => ({ open: null }));

const set = useDock.setState;

export function openDock(panel: string): void {
  set({ open: panel });
}

export function closeDock(): void {
  set({ open: null });
}

export function toggleDock(panel: string): void {
  set(({ open }) => ({ open: open === panel ? null : panel }));
}
