/** The large panels under the graph: one of them is open, or none. */
import { create } from "zustand";

export const useBelow = create<{ open: "" | "sweep" | "check" }>(() => ({ open: "" }));
