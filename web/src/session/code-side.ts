/** Which side of the code is shown beside the graph: the LLL, its listing, or the projection of the team's program. */
import { create } from "zustand";

export type CodeSide = "lll" | "listing" | "projection";

/** `side` is the one that was chosen; in a mission without a team's program there is no projection. */
export const useCodeSide = create<{ side: CodeSide }>(() => ({ side: "lll" }));

export function showCode(side: CodeSide): void {
  useCodeSide.setState({ side });
}
