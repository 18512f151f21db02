/** On a phone: which panel is open under the graph. */
import { create } from "zustand";

import type { Panel } from "./layout";

/** The panel that is open, or null for the graph alone. */
export const useNarrow = create<{ room: Panel | null }>(() => ({ room: null }));
