/** What stands under the graph stands there alone: a large panel in the place of the watch and the lists, and they in its. */
import { useEffect } from "react";

import { useBelow } from "./below";
import { useMembers } from "./members";
import { useProblemList } from "./problem-walk";
import { useWatch } from "./watching";

export function closeBelow(): void {
  useBelow.setState({ open: "" });
}

/** For a large panel, while it is there. */
export function useAlone(): void {
  useEffect(() => {
    useMembers.setState({ open: false });
    useWatch.getState().show(false);
    useProblemList.setState({ open: false });
    const ends = [useMembers, useWatch, useProblemList].map((store) =>
      store.subscribe(({ open }: { open: boolean }) => {
        if (open) closeBelow();
      }),
    );
    return () => ends.forEach((end) => end());
  }, []);
}
