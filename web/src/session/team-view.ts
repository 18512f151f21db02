/**
 * Whether the team or the world is shown in the place of a program, and what of the team is asked for.
 *
 * Undo and redo show what they change: the team for the team, the world for the world, the program for a program.
 */
import { create } from "zustand";

import { useStudio } from "../model/studio";
import type { Mission, Problem } from "../model/types";

export interface Wanted {
  what: "agent" | "goal" | "failure" | "world";
  at: number;
}

/** What stands at the side of the graph in missions with a team: roles, groups and work, or the parts. */
export type TeamSide = "team" | "parts";

/** `open`: the team is shown; `world`: the world is. Never both. */
export const useTeam = create<{ open: boolean; world: boolean; wanted: Wanted | null; side: TeamSide }>(() => ({
  open: false,
  world: false,
  wanted: null,
  side: "parts",
}));

export function showSide(side: TeamSide): void {
  useTeam.setState({ side });
}

export function openTeam(wanted: Wanted | null = null): void {
  useTeam.setState({ open: true, world: false, wanted, side: "team" });
}

/** Shows the world in the place of a program. */
export function showWorld(): void {
  useTeam.setState({ open: false, world: true, wanted: null });
}

/** Back to the program, from the team and from the world. */
export function closeTeam(): void {
  const { open, world } = useTeam.getState();
  if (open || world) useTeam.setState({ open: false, world: false, wanted: null });
}

type Parts = readonly (keyof Mission)[];

const OF_TEAM: Parts = ["agents", "goals", "failures", "breakdown", "radio", "world", "label", "help"];
const DECLARED: Parts = ["roles", "groups", "works"];
/** Codes of what is wrong with the team and its world. */
const CODES =
  /^(?:mission|run)-(?:same-name|no-start|no-storehouse|no-world|no-program|too-many-agents|no-agent|start|device|goal|failure)$/;

/** What of the team a problem is about; null when it is about something else. */
export function teamPlace(problem: Problem, mission: Mission): Wanted | null {
  if (problem.program !== "" || !CODES.test(problem.code)) return null;
  if (problem.code === "mission-no-world") return { what: "world", at: 0 };
  const found = (what: Wanted["what"], names: string[]): Wanted => {
    const at = names.findIndex((name) => problem.message.includes(`\`${name}\``));
    return { what, at: Math.max(at, 0) };
  };
  const { failures = [], goals, agents } = mission;
  if (problem.code === "mission-failure")
    return found(
      "failure",
      failures.map(({ agent }) => agent),
    );
  if (problem.code === "mission-no-storehouse" || problem.code.endsWith("-goal"))
    return found(
      "goal",
      goals.map(({ storehouse }) => storehouse),
    );
  return found(
    "agent",
    agents.map(({ name }) => name),
  );
}

/** Follows the document; the returned function ends that. */
export function keepTeamView(): () => void {
  return useStudio.subscribe((state, before) => {
    if (state.activeProgram !== before.activeProgram) closeTeam();
    const { kind } = state.change;
    if (state.change === before.change || (kind !== "undo" && kind !== "redo")) return;
    const [now, then] = [state.mission, before.mission];
    const changed = (...parts: Parts) => parts.some((part) => now[part] !== then[part]);
    // A role that has another name has it in programs too, and is seen at the side of them.
    if (changed(...DECLARED) && !changed("agents")) showSide("team");
    else if (changed("programs")) closeTeam();
    else if (changed("own_world")) showWorld();
    else if (changed(...OF_TEAM)) openTeam();
    else if (changed("breakpoints")) closeTeam();
  });
}
