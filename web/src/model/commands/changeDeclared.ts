/**
 * Adds, changes, renames and removes what a team declares: roles, groups and work.
 *
 * Roles and groups share their names with each other, and sets in the team's programs speak of them: what is renamed is
 * renamed there too. Work is an object of the team's programs, so its parts follow.
 */
import { t } from "../../i18n/words";
import { type Command, commandTo } from "../command";
import { withNamed } from "../team-names";
import { TEAM_ROBOT } from "../team-robot";
import type { Catalogue, Mission, Role, TeamGroup, Work } from "../types";

export const MOST_COUNTED = 65_535;

export const rolesOf = ({ roles }: Mission): readonly Role[] => roles ?? [];
export const groupsOf = ({ groups }: Mission): readonly TeamGroup[] => groups ?? [];
export const worksOf = ({ works }: Mission): readonly Work[] => works ?? [];

/** Every name that is declared, in the order of the text. */
export function declaredNames(mission: Mission): string[] {
  return [...rolesOf(mission), ...groupsOf(mission), ...worksOf(mission)].map((one) => one.name);
}

function isFree(mission: Mission, name: string): boolean {
  return name !== "" && !declaredNames(mission).includes(name);
}

export function addRole(mission: Mission, name: string, robot: string): Command | null {
  if (!isFree(mission, name)) return null;
  const made: Role = { name, robot, least: 1, most: 1 };
  return commandTo(t("command.add", { name }), { ...mission, roles: [...rolesOf(mission), made] });
}

/** Another kind of robot, or other numbers: `most` is never less than `least`, nor less than one. */
export function changeRole(
  mission: Mission,
  at: number,
  what: Partial<Pick<Role, "robot" | "least" | "most">>,
): Command | null {
  const role = rolesOf(mission)[at];
  if (role === undefined) return null;
  const bound = (wanted: number, least: number) => Math.min(Math.max(Math.round(wanted), least), MOST_COUNTED);
  const least = bound(what.least ?? role.least, 0);
  const most = bound(what.most ?? role.most, 1);
  const after: Role = {
    ...role,
    robot: what.robot ?? role.robot,
    least: what.most === undefined ? least : Math.min(least, most),
    most: what.most === undefined ? Math.max(least, most) : most,
  };
  if (after.robot === role.robot && after.least === role.least && after.most === role.most) return null;
  return commandTo(t("command.edit", { name: role.name }), { ...mission, roles: rolesOf(mission).with(at, after) });
}

/** A group of one member to begin with: the text of a team knows no empty one. */
export function addGroup(mission: Mission, name: string, member: string): Command | null {
  if (!isFree(mission, name) || member === "") return null;
  const made: TeamGroup = { name, members: [member], failure: "drop" };
  return commandTo(t("command.add", { name }), { ...mission, groups: [...groupsOf(mission), made] });
}

function withGroup(mission: Mission, at: number, after: TeamGroup): Command {
  return commandTo(t("command.edit", { name: after.name }), { ...mission, groups: groupsOf(mission).with(at, after) });
}

/** What the group does when a member fails. */
export function giveFailure(mission: Mission, at: number, failure: TeamGroup["failure"]): Command | null {
  const group = groupsOf(mission)[at];
  return group === undefined || group.failure === failure ? null : withGroup(mission, at, { ...group, failure });
}

/** A name more in a group; null when it is there, or is the group itself. */
export function joinGroup(mission: Mission, at: number, name: string): Command | null {
  const group = groupsOf(mission)[at];
  if (group === undefined || name === group.name || group.members.includes(name)) return null;
  return withGroup(mission, at, { ...group, members: [...group.members, name] });
}

/** A name less in a group; null when it is not there, or would leave nobody. */
export function leaveGroup(mission: Mission, at: number, name: string): Command | null {
  const group = groupsOf(mission)[at];
  if (group?.members.includes(name) !== true || group.members.length === 1) return null;
  return withGroup(mission, at, { ...group, members: group.members.filter((one) => one !== name) });
}

export function addWork(mission: Mission, name: string, units: number): Command | null {
  if (!isFree(mission, name)) return null;
  return commandTo(t("command.add", { name }), { ...mission, works: [...worksOf(mission), { name, units }] });
}

/** Other units, or another lease in seconds (null for none). */
export function changeWork(
  mission: Mission,
  at: number,
  what: { units?: number; lease?: number | null },
): Command | null {
  const work = worksOf(mission)[at];
  if (work === undefined) return null;
  const { lease: before, ...rest } = work;
  const lease = what.lease === undefined ? (before ?? null) : what.lease;
  const units = what.units ?? work.units;
  if (units === work.units && lease === (before ?? null)) return null;
  const after: Work = { ...rest, units, ...(lease === null ? {} : { lease }) };
  return commandTo(t("command.edit", { name: work.name }), { ...mission, works: worksOf(mission).with(at, after) });
}

/** The mission without a role, a group or a work; a group that held nothing else goes with it. */
export function removeDeclared(mission: Mission, name: string): Command | null {
  if (!declaredNames(mission).includes(name)) return null;
  const gone = new Set([name]);
  let groups = groupsOf(mission).filter((one) => one.name !== name);
  const isWork = worksOf(mission).some((one) => one.name === name);
  for (let before = -1; !isWork && before !== gone.size;) {
    before = gone.size;
    groups = groups.flatMap((group) => {
      const members = group.members.filter((one) => !gone.has(one));
      if (members.length === group.members.length) return [group];
      if (members.length > 0) return [{ ...group, members }];
      gone.add(group.name);
      return [];
    });
  }
  return commandTo(t("command.delete", { name }), {
    ...mission,
    roles: rolesOf(mission).filter((one) => one.name !== name),
    groups,
    works: worksOf(mission).filter((one) => one.name !== name),
  });
}

/** The mission in which an agent, a role or a group has another name wherever sets speak of it. */
export function withMember(mission: Mission, catalogue: Catalogue, name: string, to: string): Mission {
  const groups = groupsOf(mission);
  const named = groups.map((group) =>
    group.members.includes(name) ? { ...group, members: group.members.map((one) => (one === name ? to : one)) } : group,
  );
  const programs = withNamed(mission.programs, catalogue, "set", [name, to]);
  return {
    ...mission,
    programs: programs.every((one, at) => one === mission.programs[at]) ? mission.programs : programs,
    ...(named.every((one, at) => one === groups[at]) ? {} : { groups: named }),
  };
}

/** A role, a group or a work under another name, also where programs speak of it; null when that name is taken. */
export function renameDeclared(mission: Mission, catalogue: Catalogue, name: string, to: string): Command | null {
  if (!declaredNames(mission).includes(name) || !isFree(mission, to)) return null;
  const label = t("command.rename", { name });
  const named = <One extends { name: string }>(list: readonly One[]) =>
    list.map((one) => (one.name === name ? { ...one, name: to } : one));
  if (worksOf(mission).some((one) => one.name === name)) {
    const programs = mission.programs.map((program) =>
      program.robot !== TEAM_ROBOT
        ? program
        : {
            ...program,
            vertices: program.vertices.map((vertex) =>
              vertex.element.startsWith(`${name}.`)
                ? { ...vertex, element: to + vertex.element.slice(name.length) }
                : vertex,
            ),
          },
    );
    return commandTo(label, { ...mission, programs, works: named(worksOf(mission)) });
  }
  const after = withMember(mission, catalogue, name, to);
  return commandTo(label, { ...after, roles: named(rolesOf(after)), groups: named(groupsOf(after)) });
}
