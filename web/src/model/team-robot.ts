/**
 * The parts that programs of a team can call: those of all its robots and its work, as one robot without a name, which is
 * the `robot` of such a program. What a call means for the robot that does it, the server says.
 */
import type { Catalogue, Mission, Robot, RobotObject } from "./types";

export const TEAM_ROBOT = "";

/** The kinds of robots and the works of a mission's team; null where it has no program of one. */
function teamOf({ programs, roles, works }: Mission): { kinds: string[]; works: string[] } | null {
  if (programs.every((program) => program.robot !== TEAM_ROBOT)) return null;
  const kinds = [...programs.map((program) => program.robot), ...(roles ?? []).map((role) => role.robot)];
  return { kinds: [...new Set(kinds)], works: (works ?? []).map((work) => work.name) };
}

/** What the robot of a mission's team depends on; equal for missions with the same one. */
export function teamKey(mission: Mission): string {
  return JSON.stringify(teamOf(mission));
}

/** The robot of a mission's programs of a team; none where it has no such program. */
export function teamRobots({ robots, work }: Catalogue, mission: Mission): Robot[] {
  const team = teamOf(mission);
  if (team === null) return [];
  const { kinds, works } = team;
  const united = new Map<string, RobotObject>();
  for (const object of robots.filter(({ name }) => kinds.includes(name)).flatMap((robot) => robot.objects)) {
    const place = `${object.category} ${object.name}`;
    const known = united.get(place);
    const methods = new Map([...object.methods, ...(known?.methods ?? [])].map((method) => [method.name, method]));
    united.set(place, { ...(known ?? object), methods: [...methods.values()] });
  }
  const objects = [...united.values(), ...(work == null ? [] : works.map((name) => ({ ...work, name })))];
  return [{ name: TEAM_ROBOT, label: {}, help: {}, tick_ms: 20, wait_unit_ms: 100, objects }];
}
