/** Which vertices are active in the run, by id; the list of nodes does not depend on it. */
import { useEffect } from "react";
import { create } from "zustand";

import { useActiveVertices } from "../../session/run";
import { useView } from "../../session/view";

const useActive = create<{ slots: Map<string, number[]> }>(() => ({ slots: new Map() }));

/** Follows the watched agent of that program; stands once in the canvas. */
export function ActiveVertices({ program }: { program: string }): null {
  const slots = useActiveVertices(program);
  useEffect(() => {
    useActive.setState({ slots });
  }, [slots]);
  useFollowing();
  useEffect(
    () => () => {
      useActive.setState({ slots: new Map() });
    },
    [],
  );
  return null;
}

/** Keeps the vertex of the first thread in view, while that is wanted. */
function useFollowing(): void {
  const following = useView((state) => state.following);
  const slots = useActive((state) => state.slots);
  useEffect(() => {
    if (!following) return;
    const [first] = [...slots].sort(([, a], [, b]) => Math.min(...a) - Math.min(...b));
    if (first !== undefined) useView.getState().viewport?.reveal(first[0]);
  }, [following, slots]);
}

/** Threads that stand on any of these vertices, as "1 3". */
export function useThreadsAmong(ids: readonly string[]): string {
  return useActive(({ slots }) =>
    ids
      .flatMap((id) => slots.get(id) ?? [])
      .sort((a, b) => a - b)
      .join(" "),
  );
}

/** Threads that stand on one of the given vertices (`inside` is what a folded one holds), as "0 2"; "" when none does. */
export function useThreadsAt(id: string, mark: string | null, inside: readonly string[] = []): string {
  return useActive(({ slots }) => {
    if (inside.length > 0) {
      return [id, mark ?? id, ...inside].flatMap((one) => slots.get(one) ?? []).join(" ");
    }
    const here = mark === null ? slots.get(id) : [...(slots.get(id) ?? []), ...(slots.get(mark) ?? [])];
    return here === undefined ? "" : here.join(" ");
  });
}
