/**
 * What a mission brings along: constructors and variables of its own, which join those of the files.
 *
 * Both are as the server gave them, so the palette, the canvas and the inspector know no difference. They win over what is
 * there, as the server has it. Left to others: making them (the server reads their LLL), the commands that change them.
 */
import { teamRobots } from "./team-robot";
import type { Catalogue, Constructor, Group, Mission, OwnVariable, Robot } from "./types";

/** The name of the group that the mission's own constructors are in. */
export const OWN_GROUP = "Own";

const NO_CONSTRUCTORS: readonly Constructor[] = [];
const NO_VARIABLES: readonly OwnVariable[] = [];

export function ownConstructors(mission: Mission): readonly Constructor[] {
  return mission.constructors ?? NO_CONSTRUCTORS;
}

export function ownVariables(mission: Mission): readonly OwnVariable[] {
  return mission.variables ?? NO_VARIABLES;
}

function withVariables(robot: Robot, variables: readonly OwnVariable[]): Robot {
  const taken = new Set(robot.objects.map((object) => object.name));
  const own = variables
    .filter((one) => one.robot === robot.name && !taken.has(one.variable.name))
    .map((one) => one.variable);
  if (own.length === 0) return robot;
  const at = robot.objects.findLastIndex((object) => object.category !== "system") + 1;
  return { ...robot, objects: [...robot.objects.slice(0, at), ...own, ...robot.objects.slice(at)] };
}

/** The catalogue of the files with what the mission brings along and its team's robot; the same one when that is nothing. */
export function catalogueOf(files: Catalogue, mission: Mission): Catalogue {
  const constructors = ownConstructors(mission);
  const variables = ownVariables(mission);
  const team = teamRobots(files, mission);
  if (constructors.length === 0 && variables.length === 0 && team.length === 0) return files;
  const names = new Set(constructors.map((one) => one.name));
  const groups = files.groups.map((group) => ({
    ...group,
    constructors: group.constructors.filter((one) => !names.has(one.name)),
  }));
  const own: Group = {
    name: OWN_GROUP,
    colour: "action",
    icon: "package",
    label: files.own_label ?? {},
    constructors: [...constructors],
  };
  return {
    ...files,
    groups: constructors.length === 0 ? files.groups : [...groups, own],
    robots: [...files.robots, ...team].map((robot) => withVariables(robot, variables)),
  };
}
