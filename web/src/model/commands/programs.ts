/**
 * Commands on whole programs of a mission: add one for a robot, give it another name, take it out.
 *
 * A program comes and goes together with the agents that run it, so that what is drawn also runs.
 */
import type { Command } from "../command";
import type { Agent, Mission, Program } from "../types";

/** `stem-1`, `stem-2`, …: the first that is not taken. */
export function freeName(stem: string, taken: readonly string[]): string {
  for (let number = 1; ; number++) {
    const name = `${stem}-${number}`;
    if (!taken.includes(name)) return name;
  }
}

/** A new program for a robot, Start → Stop, with one agent that runs it. */
export function addProgram(mission: Mission, robot: string): { command: Command; name: string } {
  const name = freeName(
    "program",
    mission.programs.map((program) => program.name),
  );
  const program: Program = {
    name,
    robot,
    vertices: [
      { id: "start", element: "Start", settings: {}, notes: [] },
      { id: "stop", element: "Stop", settings: {}, notes: [] },
    ],
    arcs: [{ source: "start", target: "stop", out: "next", at: "in" }],
  };
  const agent: Agent = {
    name: freeName(
      robot,
      mission.agents.map((one) => one.name),
    ),
    program: name,
    start: "",
  };
  const command: Command = {
    label: `Add ${name}`,
    execute: (before) => ({ ...before, programs: [...before.programs, program], agents: [...before.agents, agent] }),
    revert: (after) => ({
      ...after,
      programs: after.programs.filter((one) => one.name !== name),
      agents: after.agents.filter((one) => one.name !== agent.name),
    }),
  };
  return { command, name };
}

/** Why a program cannot have a name, or null when it can. */
export function nameRefused(mission: Mission, from: string, to: string): "empty" | "taken" | null {
  if (to.trim() === "") return "empty";
  return to !== from && mission.programs.some((program) => program.name === to) ? "taken" : null;
}

function renamed(mission: Mission, from: string, to: string): Mission {
  return {
    ...mission,
    programs: mission.programs.map((program) => (program.name === from ? { ...program, name: to } : program)),
    agents: mission.agents.map((agent) => (agent.program === from ? { ...agent, program: to } : agent)),
  };
}

export function renameProgram(from: string, to: string): Command {
  return {
    label: `Rename ${from} to ${to}`,
    execute: (mission) => renamed(mission, from, to),
    revert: (mission) => renamed(mission, to, from),
  };
}

/** Takes a program and its agents out; null for the last one, since a mission needs one. */
export function deleteProgram(mission: Mission, name: string): Command | null {
  if (mission.programs.length < 2 || !mission.programs.some((program) => program.name === name)) return null;
  const { programs, agents } = mission;
  return {
    label: `Delete ${name}`,
    execute: (before) => ({
      ...before,
      programs: before.programs.filter((program) => program.name !== name),
      agents: before.agents.filter((agent) => agent.program !== name),
    }),
    revert: (after) => ({ ...after, programs, agents }),
  };
}
