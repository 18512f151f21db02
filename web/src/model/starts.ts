/** Where agents start. Apart from the commands on agents, which are fetched later. */
import type { Agent } from "./types";

/** The name of a start of the world. */
export function startOf(agent: Agent): string {
  return agent.start === "" ? agent.name : agent.start;
}
