/** The names of a mission that a team's text can speak of. Apart from what offers them, which is loaded later. */
import { inSet } from "../../model/team-names";
import { TEAM_ROBOT } from "../../model/team-robot";
import type { Mission, Robot } from "../../model/types";

/** Names that a team's text can speak of, each with what is said beside it. */
export interface TeamNames {
  roles: readonly Named[];
  groups: readonly Named[];
  agents: readonly Named[];
  /** Those that may stand in this one by `PROGRAM`. */
  programs: readonly Named[];
  robots: readonly Named[];
}

export interface Named {
  name: string;
  detail: string;
}

const LEVELS = ["agent", "group", "social"];

/** The names that the text of a program can speak of; `robots`: the kinds of robots at hand. */
export function teamNames(mission: Mission, robots: readonly Robot[], program: string): TeamNames {
  const own = LEVELS.indexOf(mission.programs.find((one) => one.name === program)?.level ?? "agent");
  const kind = (name: string) => mission.programs.find((one) => one.name === name)?.robot ?? "";
  return {
    roles: (mission.roles ?? []).map(({ name, robot }) => ({ name, detail: robot })),
    groups: (mission.groups ?? []).map(({ name, members }) => ({ name, detail: members.map(inSet).join(", ") })),
    agents: mission.agents.map((agent) => ({ name: agent.name, detail: agent.robot ?? kind(agent.program) })),
    programs: mission.programs
      .filter((one) => one.name !== program && LEVELS.indexOf(one.level ?? "agent") <= own)
      .map(({ name, robot }) => ({ name, detail: robot })),
    robots: robots.filter(({ name }) => name !== TEAM_ROBOT).map(({ name }) => ({ name, detail: "" })),
  };
}
