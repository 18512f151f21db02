/** Adds, renames and removes whole programs of the mission. Agents follow a renamed program. */
import { t } from "../../i18n/words";
import { type Command, commandTo } from "../command";
import { withNamed } from "../team-names";
import type { Catalogue, Mission, Program } from "../types";
import { breakpointsRenamed } from "./changeBreakpoints";

/** The paper's smallest graph: Start, then Stop. */
export function emptyProgram(name: string, robot: string, level: Program["level"] = "agent"): Program {
  return {
    name,
    robot,
    ...(level === "agent" ? {} : { level }),
    vertices: [
      { id: "start", element: "Start", settings: {}, notes: [] },
      { id: "stop", element: "Stop", settings: {}, notes: [] },
    ],
    arcs: [{ source: "start", target: "stop", out: "next", at: "in" }],
  };
}

/** A new program at the end, or null when its name is taken or empty. */
export function addProgram(mission: Mission, program: Program): Command | null {
  const { name } = program;
  if (name === "" || mission.programs.some((one) => one.name === name)) return null;
  return commandTo(t("command.add", { name }), { ...mission, programs: [...mission.programs, program] });
}

/**
 * The program under another name, its agents and the team's programs that name it with it, or null when that name is
 * taken or empty.
 */
export function renameProgram(mission: Mission, name: string, to: string, catalogue?: Catalogue): Command | null {
  if (to === "" || mission.programs.some((one) => one.name === to)) return null;
  if (!mission.programs.some((one) => one.name === name)) return null;
  const named =
    catalogue === undefined ? mission.programs : withNamed(mission.programs, catalogue, "program", [name, to]);
  return commandTo(t("command.rename", { name }), {
    ...mission,
    programs: named.map((one) => (one.name === name ? { ...one, name: to } : one)),
    agents: mission.agents.map((one) => (one.program === name ? { ...one, program: to } : one)),
    ...breakpointsRenamed(mission, name, to),
  });
}

/** Without that program and its agents, or null when it is the only one. */
export function removeProgram(mission: Mission, name: string): Command | null {
  if (mission.programs.length <= 1 || !mission.programs.some((one) => one.name === name)) return null;
  return commandTo(t("command.delete", { name }), {
    ...mission,
    programs: mission.programs.filter((one) => one.name !== name),
    agents: mission.agents.filter((one) => one.program !== name),
  });
}

/** The command, or null when there is no neighbour on that side. */
export function moveProgram(mission: Mission, name: string, by: 1 | -1): Command | null {
  const from = mission.programs.findIndex((one) => one.name === name);
  const moved = mission.programs[from];
  if (moved === undefined || mission.programs[from + by] === undefined) return null;
  const programs = mission.programs.filter((one) => one !== moved);
  programs.splice(from + by, 0, moved);
  return commandTo(t("command.move", { name }), { ...mission, programs });
}
