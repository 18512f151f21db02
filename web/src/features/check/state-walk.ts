/**
 * A walk by hand through the states of the mission: the steps that were taken, and what the server says of where they lead.
 *
 * It keeps the mission that it began with, whatever is edited since; it goes when another mission is opened. Each answer
 * is whole, so that of several requests the last one counts.
 */
import { create } from "zustand";

import type { StateWalk } from "../../api/generated";
import { type WhyRefused, whyRefused } from "../../api/refusal";
import { walkApi, type WantedWalk } from "../../api/state-walk";
import { useStudio } from "../../model/studio";
import { useRun } from "../../session/run";
import { type Kinds, USUAL } from "./kinds";
import type { Assumption } from "./table";

type Wanted = WantedWalk & { kinds: Kinds };

interface Walk {
  /** What was asked last; null: no walk is open. */
  wanted: Wanted | null;
  /** Where it has come to; null before the first answer. */
  state: StateWalk | null;
  busy: boolean;
  refused: WhyRefused | null;
}

const NONE: Walk = { wanted: null, state: null, busy: false, refused: null };

export const useStateWalk = create<Walk>(() => NONE);

/** Begins a walk under an assumption; of a mission that was checked, the steps of a run are taken at once. */
export function beginWalk(
  { timing, failures }: Assumption,
  asked: Pick<Wanted, "mission" | "path" | "seed" | "kinds"> = open(),
  places: readonly number[] = [],
): void {
  useStateWalk.setState(NONE);
  const { mission, path, seed, kinds } = asked;
  ask({ mission, path, seed, timing, failures, kinds, places: [...places], goes_on: false });
}

function open() {
  const { mission, file } = useStudio.getState();
  return { mission, path: file.path, seed: useRun.getState().seed, kinds: USUAL };
}

export function closeWalk(): void {
  useStateWalk.setState(NONE);
}

/** Takes a possible step. */
export function takeStep(place: number): void {
  const { wanted, state } = useStateWalk.getState();
  if (wanted !== null && state !== null) ask({ ...wanted, places: [...state.places, place], goes_on: false });
}

/** Takes steps while only one is possible, failures aside. */
export function goOn(): void {
  const { wanted, state } = useStateWalk.getState();
  if (wanted !== null && state !== null) ask({ ...wanted, places: state.places, goes_on: true });
}

/** Takes back the last step, or all of them. */
export function goBack(all = false): void {
  const { wanted, state } = useStateWalk.getState();
  if (wanted !== null) ask({ ...wanted, places: all ? [] : (state?.places ?? []).slice(0, -1), goes_on: false });
}

/** The same mission under another assumption, from its first state on. */
export function assume(assumption: Assumption): void {
  const { wanted } = useStateWalk.getState();
  if (wanted !== null) ask({ ...wanted, ...assumption, places: [], goes_on: false });
}

function ask(wanted: Wanted): void {
  useStateWalk.setState({ wanted, busy: true });
  const isLast = () => useStateWalk.getState().wanted === wanted;
  walkApi.walk(wanted).then(
    (state) => {
      if (isLast()) useStateWalk.setState({ state, busy: false, refused: null });
    },
    (cause: unknown) => {
      if (isLast()) useStateWalk.setState({ busy: false, refused: whyRefused(cause) });
    },
  );
}

useStudio.subscribe((studio, before) => {
  if (studio.change !== before.change && studio.change.kind === "open") closeWalk();
});
