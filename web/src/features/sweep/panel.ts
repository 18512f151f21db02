/** Whether the panel of the sweep is open. */
import { create } from "zustand";

export const useSweepPanel = create(() => ({ open: false }));
