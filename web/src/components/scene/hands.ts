/**
 * A person's hand on the keys of a board: a key is held while it is pressed, and goes over the same road as any sensor
 * whose value is forced, so the run's recording says what was done.
 *
 * However short, a press lasts until the program has felt it: a tick may be over before the next message of the run is
 * here, and a run may pause. Left to others: where keys are (draw-board, Hands), who may touch the run (run).
 */
import { create } from "zustand";

import { can, isLive, useRun } from "../../session/run";

interface Hold {
  agent: string;
  sensor: string;
  /** The run it belongs to. */
  run: string;
  since: number;
  /** Whether the hand has gone already. */
  let: boolean;
}

interface Hands {
  /** What is held now, by a hand or because the program has not felt it yet. */
  held: readonly Hold[];
}

/** A program that has felt nothing for so many ticks will not: it has ended, or it failed. */
const PATIENCE_TICKS = 250;

export const useHands = create<Hands>(() => ({ held: [] }));

function is(hold: Hold, agent: string, sensor: string): boolean {
  return hold.agent === agent && hold.sensor === sensor;
}

export function isHeld(held: readonly Hold[], agent: string, sensor: string): boolean {
  return held.some((hold) => is(hold, agent, sensor));
}

/** Presses a key; false where nobody may. */
export function press(agent: string, sensor: string): boolean {
  const run = useRun.getState();
  if (!can("force", run) || !isLive(run.status)) return false;
  const { held } = useHands.getState();
  if (isHeld(held, agent, sensor)) {
    useHands.setState({ held: held.map((hold) => (is(hold, agent, sensor) ? { ...hold, let: false } : hold)) });
    return true;
  }
  useHands.setState({ held: [...held, { agent, sensor, run: run.name, since: run.tick, let: false }] });
  run.force(agent, sensor, 1);
  return true;
}

/** Gives back what was let go and felt, and forgets what belongs to a run that is over. */
function settle(): void {
  const { held } = useHands.getState();
  if (held.length === 0) return;
  const run = useRun.getState();
  const over = ({ run: name }: Hold) => name !== run.name || !isLive(run.status);
  const felt = ({ agent, sensor, since }: Hold) =>
    run.agents.find(({ name }) => name === agent)?.inputs[sensor] === 1 || run.tick > since + PATIENCE_TICKS;
  const gone = held.filter((hold) => over(hold) || (hold.let && felt(hold)));
  if (gone.length === 0) return;
  useHands.setState({ held: held.filter((hold) => !gone.includes(hold)) });
  for (const hold of gone) if (!over(hold)) run.force(hold.agent, hold.sensor, null);
}

export function release(agent: string, sensor: string): void {
  useHands.setState(({ held }) => ({
    held: held.map((hold) => (is(hold, agent, sensor) ? { ...hold, let: true } : hold)),
  }));
  settle();
}

/** The hand has left the arena. */
export function releaseAll(): void {
  useHands.setState(({ held }) => ({ held: held.map((hold) => ({ ...hold, let: true })) }));
  settle();
}

useRun.subscribe(settle);
