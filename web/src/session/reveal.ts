/** Asks the palette to show a part, whatever is searched for, and to give it the focus. */
import { create } from "zustand";

interface RevealState {
  element: string;
  /** Counts the askings: the same part may be asked for again. */
  times: number;
}

export const useReveal = create<RevealState>(() => ({ element: "", times: 0 }));

export function reveal(element: string): void {
  useReveal.setState(({ times }) => ({ element, times: times + 1 }));
}
