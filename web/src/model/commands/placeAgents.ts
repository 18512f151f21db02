/** Puts agents that have no start in the world on free starts. */
import { t } from "../../i18n/words";
import { becomes, type Command } from "../command";
import type { Mission } from "../types";
import { startOf } from "../starts";

/** `starts` are those of the world; null when every agent has one, or none is free. */
export function placeAgents(mission: Mission, starts: readonly string[]): Command | null {
  const taken = new Set(mission.agents.map(startOf));
  const free = starts.filter((start) => !taken.has(start));
  const agents = mission.agents.map((agent) => {
    const start = starts.includes(startOf(agent)) ? undefined : free.shift();
    return start === undefined ? agent : { ...agent, start: start === agent.name ? "" : start };
  });
  if (agents.every((agent, at) => agent === mission.agents[at])) return null;
  return becomes(t("command.place"), { ...mission, agents });
}
