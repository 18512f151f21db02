/** What is printed, and how: remembered until the page is closed. */
import { create } from "zustand";

export interface PrintChoice {
  /** The program in view alone, without the team. */
  one: boolean;
  /** Each graph whole on one page, however small; otherwise a large one is cut into parts that can be read. */
  fit: boolean;
}

export const usePrintChoice = create<PrintChoice>(() => ({ one: false, fit: false }));

export function choosePrint(choice: Partial<PrintChoice>): void {
  usePrintChoice.setState(choice);
}
