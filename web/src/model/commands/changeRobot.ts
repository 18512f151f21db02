/** Gives a program another robot; the mission's own variables that it uses come along. */
import { t } from "../../i18n/words";
import { type Command, commandTo } from "../command";
import { ownConstructors, ownVariables } from "../own-parts";
import { robotKinds } from "../robot-kinds";
import { TEAM_ROBOT } from "../team-robot";
import type { Catalogue, Mission, Program, Robot } from "../types";
import { withOwn } from "./changeOwn";

/**
 * The program for `robot`, a name of the catalogue, or null when it is that already, is one of a team, or there is no
 * such robot. Its vertices stay: what the new robot lacks is a problem that is shown, not a part that is lost.
 */
export function changeRobot(mission: Mission, catalogue: Catalogue, name: string, robot: string): Command | null {
  const program = mission.programs.find((one) => one.name === name);
  const wanted = catalogue.robots.find((one) => one.name === robot);
  if (program === undefined || wanted === undefined || robot === program.robot) return null;
  if (program.robot === TEAM_ROBOT || robot === TEAM_ROBOT) return null;
  const programs = mission.programs.map((one) => (one === program ? { ...one, robot } : one));
  const variables = [...ownVariables(mission), ...variablesFor(wanted, mission, program)];
  const label = robotKinds(catalogue.robots).find((one) => one.name === robot)?.label ?? robot;
  return commandTo(
    t("command.change", { name: label }),
    withOwn({ ...mission, programs }, ownConstructors(mission), variables),
  );
}

/** Copies of those variables of the mission that the program uses and the robot has no object for. */
function variablesFor(robot: Robot, mission: Mission, program: Program) {
  const has = new Set(robot.objects.map((object) => object.name));
  return ownVariables(mission)
    .filter((one) => one.robot === program.robot && !has.has(one.variable.name))
    .filter(({ variable }) => program.vertices.some(({ element }) => element.startsWith(`${variable.name}.`)))
    .map((one) => ({ ...one, robot: robot.name }));
}
