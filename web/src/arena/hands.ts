/**
 * A person's hand on the keys of a board: a key is held while it is pressed, and goes over the same road as any sensor
 * whose value is forced, so the run's recording says what was done.
 *
 * However short, a press lasts until the program has had its tick to see it; in a run that pauses, until it goes on. Left
 * to others: where keys are (draw-board, Hands), and whether anybody may touch the run (run).
 */
import { create } from "zustand";

import { useStudio } from "../model/studio";
import { canInterfere, useRun } from "../run/run";

interface Hold {
  agent: string;
  sensor: string;
  /** The run it belongs to. */
  run: string;
  /** The program has seen it from this tick on. */
  seenAt: number;
  /** Whether the hand has gone already. */
  let: boolean;
}

interface Hands {
  /** What is held now. */
  held: readonly Hold[];
}

export const useHands = create<Hands>(() => ({ held: [] }));

function is(hold: Hold, agent: string, sensor: string): boolean {
  return hold.agent === agent && hold.sensor === sensor;
}

export function isHeld(held: readonly Hold[], agent: string, sensor: string): boolean {
  return held.some((hold) => is(hold, agent, sensor) && !hold.let);
}

/** How many ticks of the run a program takes to look once. */
function ticksToSee(agent: string): number {
  const { agents, tickMs } = useRun.getState();
  const robot = agents.find(({ name }) => name === agent)?.robot;
  const period = useStudio.getState().catalogue.robots.find(({ name }) => name === robot)?.tick_ms ?? tickMs;
  return Math.ceil(period / Math.max(tickMs, 1)) + 1;
}

/** Presses a key; false where nobody may. */
export function press(agent: string, sensor: string): boolean {
  const run = useRun.getState();
  if (!canInterfere(run)) return false;
  const { held } = useHands.getState();
  if (held.some((hold) => is(hold, agent, sensor) && hold.run === run.name)) {
    useHands.setState({ held: held.map((hold) => (is(hold, agent, sensor) ? { ...hold, let: false } : hold)) });
    return true;
  }
  const hold = { agent, sensor, run: run.name, seenAt: run.tick + ticksToSee(agent), let: false };
  useHands.setState({ held: [...held.filter((one) => one.run === run.name), hold] });
  run.force(agent, sensor, 1);
  return true;
}

/** Gives back what was let go and seen, and forgets what belongs to another run. */
function settle(): void {
  const { held } = useHands.getState();
  if (held.length === 0) return;
  const run = useRun.getState();
  const gone = held.filter((hold) => hold.run !== run.name || (hold.let && run.tick >= hold.seenAt));
  if (gone.length === 0) return;
  useHands.setState({ held: held.filter((hold) => !gone.includes(hold)) });
  for (const { agent, sensor, run: name } of gone) {
    if (name === run.name && canInterfere(run)) run.force(agent, sensor, null);
  }
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
