/**
 * Adds, changes, copies, moves and removes agents of the team.
 *
 * An agent without a start of its own starts at the place of its name; whoever renames it leaves it where it is.
 */
import { t } from "../../i18n/words";
import { type Command, commandTo, withOptional } from "../command";
import { startOf } from "../starts";
import { TEAM_ROBOT } from "../team-robot";
import type { Agent, Catalogue, Mission } from "../types";
import { kindOf } from "./castAgents";
import { declaredNames, groupsOf, rolesOf, withMember } from "./changeDeclared";

function withAgents(label: string, before: Mission, agents: Agent[], trial: Partial<Mission> = {}): Command {
  return commandTo(label, withOptional({ ...before, agents }, trial));
}

function has(mission: Mission, name: string): boolean {
  return mission.agents.some((agent) => agent.name === name);
}

/** The agent at that start, said in the shortest way. */
function startingAt(agent: Agent, start: string): Agent {
  return { ...agent, start: start === agent.name ? "" : start };
}

/** What a mission says about trying it out, with another name for an agent, or without it where that is null. */
function trialWith(mission: Mission, name: string, to: string | null): Partial<Mission> {
  const named = (one: string) => (one === name ? to : one);
  const breakpoints = mission.breakpoints?.flatMap((one) => {
    if (one.agents?.includes(name) !== true) return [one];
    const agents = one.agents.map(named).filter((agent) => agent !== null);
    // One that was for this agent alone would else be for all of them.
    return agents.length === 0 ? [] : [{ ...one, agents }];
  });
  const failures = mission.failures?.flatMap((one) => {
    const agent = named(one.agent);
    return agent === null ? [] : [agent === one.agent ? one : { ...one, agent }];
  });
  return {
    ...(breakpoints === undefined ? {} : { breakpoints }),
    ...(failures === undefined ? {} : { failures }),
  };
}

/** A new agent at the end; null when the name is taken or empty. */
export function addAgent(mission: Mission, name: string, program: string, start: string): Command | null {
  if (name === "" || has(mission, name)) return null;
  const like = mission.agents.findLast((one) => one.program === program)?.robot ?? rolesOf(mission)[0]?.robot;
  const made = running(
    mission,
    { name, program: "", start: "", ...(like === undefined ? {} : { robot: like }) },
    program,
  );
  const agent = startingAt(made, start === "" ? name : start);
  return withAgents(t("command.add", { name }), mission, [...mission.agents, agent]);
}

/** The agent with that program: one of the whole team runs it as the kind of robot that it was before. */
function running(mission: Mission, agent: Agent, program: string): Agent {
  const { robot: _, ...rest } = agent;
  const ofTeam = mission.programs.find((one) => one.name === program)?.robot === TEAM_ROBOT;
  const robot = kindOf(mission, agent);
  return ofTeam && robot !== "" ? { ...rest, program, robot } : { ...rest, program };
}

/** The agent with another program; null when that is none, or the one it has. */
export function giveProgram(mission: Mission, at: number, program: string): Command | null {
  const agent = mission.agents[at];
  if (agent === undefined || agent.program === program) return null;
  if (!mission.programs.some((one) => one.name === program)) return null;
  const label = t("command.edit", { name: agent.name });
  return withAgents(label, mission, mission.agents.with(at, running(mission, agent, program)));
}

/** The agent at another start of the world; null when it starts there already. */
export function giveStart(mission: Mission, at: number, start: string): Command | null {
  const agent = mission.agents[at];
  if (agent === undefined || start === "" || startOf(agent) === start) return null;
  const label = t("command.edit", { name: agent.name });
  return withAgents(label, mission, mission.agents.with(at, startingAt(agent, start)));
}

/**
 * The agent under another name, at the place where it was, and so in breakpoints, failures, groups and the sets of the
 * team's programs; null when that name is taken or empty.
 */
export function renameAgent(mission: Mission, at: number, name: string, catalogue?: Catalogue): Command | null {
  const agent = mission.agents[at];
  if (agent === undefined || name === "" || has(mission, name)) return null;
  const renamed = startingAt({ ...agent, name }, startOf(agent));
  const trial = trialWith(mission, agent.name, name);
  // A role or a group of that name is meant before the agent.
  const meant = catalogue !== undefined && !declaredNames(mission).includes(agent.name);
  const named = meant ? withMember(mission, catalogue, agent.name, name) : mission;
  return withAgents(t("command.rename", { name: agent.name }), named, mission.agents.with(at, renamed), trial);
}

/** Another agent like that one, behind it, under a name and at a start of its own. */
export function copyAgent(mission: Mission, at: number, name: string, start: string): Command | null {
  const agent = mission.agents[at];
  if (agent === undefined || name === "" || has(mission, name)) return null;
  const copy = startingAt({ ...agent, name }, start);
  return withAgents(t("command.add", { name }), mission, mission.agents.toSpliced(at + 1, 0, copy));
}

/** The agent at another place of the list; null when it is there. */
export function moveAgent(mission: Mission, at: number, to: number): Command | null {
  const agent = mission.agents[at];
  if (agent === undefined || to === at || to < 0 || to >= mission.agents.length) return null;
  const agents = mission.agents.toSpliced(at, 1).toSpliced(to, 0, agent);
  return withAgents(t("command.move", { name: agent.name }), mission, agents);
}

/** Groups without an agent, as far as they hold others. */
function groupsWithout(mission: Mission, name: string): Partial<Mission> {
  if (declaredNames(mission).includes(name) || groupsOf(mission).every((one) => !one.members.includes(name))) return {};
  const without = (members: string[]) => members.filter((one) => one !== name);
  return {
    groups: groupsOf(mission).map((one) =>
      without(one.members).length === 0 ? one : { ...one, members: without(one.members) },
    ),
  };
}

export function removeAgent(mission: Mission, at: number): Command | null {
  const agent = mission.agents[at];
  if (agent === undefined) return null;
  const trial = { ...trialWith(mission, agent.name, null), ...groupsWithout(mission, agent.name) };
  return withAgents(t("command.delete", { name: agent.name }), mission, mission.agents.toSpliced(at, 1), trial);
}

/** `starts` are those of the world; null when every agent has one, or none is free. */
export function placeAgents(mission: Mission, starts: readonly string[]): Command | null {
  const taken = new Set(mission.agents.map(startOf));
  const free = starts.filter((start) => !taken.has(start));
  const agents = mission.agents.map((agent) => {
    const start = starts.includes(startOf(agent)) ? undefined : free.shift();
    return start === undefined ? agent : { ...agent, start: start === agent.name ? "" : start };
  });
  if (agents.every((agent, at) => agent === mission.agents[at])) return null;
  return commandTo(t("command.place"), { ...mission, agents });
}
