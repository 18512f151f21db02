/** Runs of the simulator that show what a check found: played as fast as they go up to the moment, where they pause. */
import { create } from "zustand";

import type { ConfirmingRun } from "../api/generated";
import type { Mission, Problem } from "../model/types";
import { isLive, useRun } from "./run";

/** Simulated seconds of a run in which the server looks for what is broken: those that are played take as long. */
const RUN_S = 600;

/** What a run is of. */
interface Whose {
  mission: Mission;
  path: string;
}

/** Whether nothing can be played now: real robots go on at their own pace, and are not left to themselves. */
export function isHeldByRobots(): boolean {
  const { real, status } = useRun.getState();
  return real && isLive(status);
}

/** Whether what goes on goes at its own pace: real robots, or a fleet. */
export function isHeldByRobotsOrFleet(): boolean {
  const { isFleet, status } = useRun.getState();
  return isHeldByRobots() || (isFleet && isLive(status));
}

/** The mission with what befell agents in a run on its schedule. */
export function withFailures(mission: Mission, run: ConfirmingRun): Mission {
  const failures = [...(mission.failures ?? []), ...run.failures];
  return failures.length === 0 ? mission : { ...mission, failures: failures.sort((a, b) => a.at_s - b.at_s) };
}

/** Ends waiting for the moment of the run that is played. */
const useFollowing = create<{ end: (() => void) | null }>(() => ({ end: null }));

export function playConfirming({ mission, path }: Whose, run: ConfirmingRun): void {
  if (isHeldByRobots()) return;
  useFollowing.getState().end?.();
  const changed = withFailures(mission, run);
  const like = { mission: changed, seed: run.seed, speed: 0, fail_rate: 0, seconds: RUN_S };
  useRun.getState().start({ mission, path }, like);
  const end = useRun.subscribe((now) => {
    if (now.status === "connecting") return;
    const there = now.tick >= run.tick;
    if (now.status === "running" && !there) return;
    end();
    useFollowing.setState({ end: null });
    if (!there) return;
    now.pause();
    now.seek(run.tick);
    now.setSpeed(now.speed);
  });
  useFollowing.setState({ end });
}

const shown = new WeakMap<Problem, Whose & { run: ConfirmingRun }>();

/** Says that a run shows this problem. */
export function showsProblem(problem: Problem, whose: Whose, run: ConfirmingRun): void {
  shown.set(problem, { ...whose, run });
}

/** Plays the run that shows a problem; null where none does. */
export function runOf(problem: Problem): (() => void) | null {
  const found = shown.get(problem);
  return found === undefined ? null : () => playConfirming(found, found.run);
}
