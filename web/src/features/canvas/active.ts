/** Which vertices are active in the run, by id; the list of nodes does not depend on it. */
import { useEffect, useMemo } from "react";
import { create } from "zustand";

import { useStudio } from "../../model/studio";
import { onlyCalls } from "../../model/team-names";
import { useDrag } from "../../session/drag";
import { standingIn, useActiveVertices, useRun } from "../../session/run";
import { follows, resumeFollowing, useView } from "../../session/view";

/** Threads by their numbers; of a team its members, as `@PLACE`. */
type Slots = ReadonlyMap<string, readonly (number | string)[]>;

const useActive = create<{ slots: Slots }>(() => ({ slots: new Map() }));

/** Follows the watched agent of that program; stands once in the canvas. */
export function ActiveVertices({ program }: { program: string }): null {
  const threads = useActiveVertices(program);
  const agents = useRun((run) => run.agents);
  const team = useRun((run) => run.team);
  const status = useRun((run) => run.status);
  const mission = useRun((run) => run.mission);
  const catalogue = useStudio((studio) => studio.catalogue);
  const calls = useMemo(() => onlyCalls(mission?.programs ?? [], catalogue), [mission, catalogue]);
  const members = useMemo(
    () => standingIn({ agents, team, status }, program, calls),
    [agents, team, status, program, calls],
  );
  const slots: Slots = members.size > 0 ? members : threads;
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

// What was put by hand during one run does not hold for the next.
useRun.subscribe(({ status }, before) => {
  if (status === "running" && before.status === "connecting") resumeFollowing();
});

/** Whether somebody writes or chooses something at a vertex, or drags: the canvas does not move away under that. */
const busy = () => {
  const { adding, editing, noting, menu } = useView.getState();
  return [adding, editing, noting, menu, useDrag.getState().payload].some((one) => one !== null);
};

/** Keeps the vertex of the first thread in view, while that is wanted. */
function useFollowing(): void {
  const following = useView(follows);
  const slots = useActive((state) => state.slots);
  useEffect(() => {
    if (!following || busy()) return;
    const least = (slots: readonly (number | string)[]) =>
      Math.min(...slots.map((one) => Number(String(one).replace("@", ""))));
    const [first] = [...slots].sort(([, a], [, b]) => least(a) - least(b));
    if (first !== undefined) useView.getState().viewport?.reveal(first[0]);
  }, [following, slots]);
}

/** Threads that stand on any of these vertices, as "1 3". */
export function useThreadsAmong(ids: readonly string[]): string {
  return useActive(({ slots }) =>
    ids
      .flatMap((id) => slots.get(id) ?? [])
      .sort((a, b) => (typeof a === "number" && typeof b === "number" ? a - b : 0))
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
