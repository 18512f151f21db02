/** The folded constructors of each program, as the drawing asks for them; `folded.ts` folds and unfolds. */
import { create } from "zustand";

type Ids = ReadonlySet<string>;

const NONE: Ids = new Set();

interface FoldState {
  folded: ReadonlyMap<string, Ids>;
  set: (program: string, ids: Ids) => void;
  unfoldAll: () => void;
}

export const useFolded = create<FoldState>((set, get) => ({
  folded: new Map(),
  set: (program, ids) => set({ folded: new Map([...get().folded, [program, ids]]) }),
  unfoldAll: () => set({ folded: new Map() }),
}));

export function foldedIn(program: string): Ids {
  return useFolded.getState().folded.get(program) ?? NONE;
}
