/**
 * Who plays which role, and who is to: agents are put into roles and taken out of them.
 *
 * A run gives each role, in the order of declaration, the first free agents of its kind, up to its largest number, but
 * those that later roles need at least (`sim.setup.team_tables.filled`, which says the same). So putting an agent into a role
 * changes the order of the agents and, where they do not fit, how many the roles want.
 */
import { t } from "../../i18n/words";
import { type Command, commandTo } from "../command";
import { TEAM_ROBOT } from "../team-robot";
import type { Agent, Mission, Role } from "../types";
import { rolesOf } from "./changeDeclared";

/** The program of the whole team that agents run; the first one there is where none does; "" without one. */
export function socialOf({ programs, agents }: Mission): string {
  const social = programs.filter((one) => one.level === "social").map((one) => one.name);
  return agents.find((one) => social.includes(one.program))?.program ?? social[0] ?? "";
}

/** Whether an agent runs the team's program. */
export function isOfTeam(mission: Mission, { program }: Agent): boolean {
  return program !== "" && program === socialOf(mission);
}

/** The kind of robot that an agent is. */
export function kindOf({ programs }: Mission, { program, robot }: Agent): string {
  if (robot !== undefined && robot !== "") return robot;
  return programs.find((one) => one.name === program)?.robot ?? "";
}

function filled(roles: readonly Role[], agents: readonly Agent[]): Map<string, string> {
  const playing = new Map<string, string>();
  roles.forEach((role, number) => {
    const free = agents.filter((one) => one.robot === role.robot && !playing.has(one.name));
    const later = roles.slice(number + 1).filter((one) => one.robot === role.robot);
    const needed = later.reduce((sum, one) => sum + one.least, 0);
    const wanted = Math.min(role.most, Math.max(role.least, free.length - needed));
    for (const one of free.slice(0, Math.max(wanted, 0))) playing.set(one.name, role.name);
  });
  return playing;
}

/** Agent → the role that it plays when a run begins; who is not in it is spare, or not of the team. */
export function playing(mission: Mission): Map<string, string> {
  return filled(
    rolesOf(mission),
    mission.agents.filter((one) => isOfTeam(mission, one)),
  );
}

/** Why an agent cannot be put into a role, or taken out of it (""): "" where it can. */
export function whyNotCast(mission: Mission, at: number, to: string): string {
  const agent = mission.agents[at];
  const role = rolesOf(mission).find((one) => one.name === to);
  if (agent === undefined || (to !== "" && role === undefined)) return t("roster.gone");
  const kind = kindOf(mission, agent);
  if (role !== undefined && kind !== role.robot) {
    return t("roster.other-kind", { agent: agent.name, kind, role: to, wanted: role.robot });
  }
  const from = playing(mission).get(agent.name);
  const left = [...playing(mission).values()].filter((one) => one === from).length;
  return from !== undefined && from !== to && left === 1 ? t("roster.last", { agent: agent.name, role: from }) : "";
}

/** An agent put into a role, or with "" among the spare ones; null where that is so already, or cannot be. */
export function castAgent(mission: Mission, at: number, to: string): Command | null {
  const agent = mission.agents[at];
  const social = socialOf(mission);
  if (agent === undefined || social === "" || whyNotCast(mission, at, to) !== "") return null;
  const before = playing(mission);
  if (isOfTeam(mission, agent) && (before.get(agent.name) ?? "") === to) return null;
  const kind = kindOf(mission, agent);
  const agents = mission.agents.with(at, { ...agent, program: social, robot: kind });
  const joined = { ...mission, agents };
  const wanted = new Map(before);
  if (to === "") wanted.delete(agent.name);
  else wanted.set(agent.name, to);
  const count = (role: Role) => [...wanted.values()].filter((one) => one === role.name).length;
  const label = t("command.cast", { name: agent.name });
  for (const exact of [false, true]) {
    const roles = rolesOf(mission).map((role) => {
      const now = count(role);
      if (role.robot !== kind || now === 0) return role;
      const most = exact || role.name === before.get(agent.name) ? now : Math.max(role.most, now);
      return most === role.most ? role : { ...role, most, least: Math.min(role.least, most) };
    });
    const after = { ...joined, roles, agents: inOrder(joined, roles, wanted, kind) };
    const found = filled(
      roles,
      after.agents.filter((one) => one.program === social),
    );
    if (exact || [...wanted].every(([name, role]) => found.get(name) === role)) {
      if (exact || found.size === wanted.size) return commandTo(label, after);
    }
  }
  return null;
}

/** The agents, those of a kind among themselves in the order of the roles that they are to play, spare ones last. */
function inOrder(
  { agents }: Mission,
  roles: readonly Role[],
  wanted: ReadonlyMap<string, string>,
  kind: string,
): Agent[] {
  const rank = (agent: Agent) => {
    const at = roles.findIndex((role) => role.name === wanted.get(agent.name));
    return at < 0 ? roles.length : at;
  };
  const mine = (agent: Agent) => agent.robot === kind;
  const sorted = agents.filter(mine).sort((one, other) => rank(one) - rank(other));
  return agents.map((agent) => (mine(agent) ? (sorted.shift() ?? agent) : agent));
}

/** Another kind of robot for an agent of the team; null when it is one already. */
export function giveKind(mission: Mission, at: number, robot: string): Command | null {
  const agent = mission.agents[at];
  if (agent === undefined || robot === TEAM_ROBOT || agent.robot === robot) return null;
  return commandTo(t("command.edit", { name: agent.name }), {
    ...mission,
    agents: mission.agents.with(at, { ...agent, robot }),
  });
}
