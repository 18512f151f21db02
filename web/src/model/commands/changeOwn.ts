/**
 * Adds, changes and removes the parts that a mission brings along. Where a part gets another name, what is made of it
 * follows in every program.
 */
import { t } from "../../i18n/words";
import { type Command, commandTo, withOptional } from "../command";
import { ownConstructors, ownVariables } from "../own-parts";
import type { Constructor, Mission, OwnVariable, Program } from "../types";

/** The mission with these lists, each left out when it is empty, as in a mission that never had one. */
export function withOwn(
  mission: Mission,
  constructors: readonly Constructor[],
  variables: readonly OwnVariable[],
): Mission {
  return withOptional(mission, { constructors: [...constructors], variables: [...variables] });
}

function renamed(program: Program, rename: (element: string) => string): Program {
  const vertices = program.vertices.map((vertex) => {
    const element = rename(vertex.element);
    return element === vertex.element ? vertex : { ...vertex, element };
  });
  return vertices.every((vertex, at) => vertex === program.vertices[at]) ? program : { ...program, vertices };
}

/** The programs in which a constructor stands, and how often. */
export function usesOfConstructor(mission: Mission, name: string): { program: string; vertices: string[] }[] {
  return uses(mission, (_, element) => element === name);
}

/** The programs in which a variable is used, and the vertices that do. */
export function usesOfVariable(
  mission: Mission,
  robot: string,
  variable: string,
): { program: string; vertices: string[] }[] {
  return uses(mission, (program, element) => program.robot === robot && element.startsWith(`${variable}.`));
}

function uses(mission: Mission, is: (program: Program, element: string) => boolean) {
  return mission.programs.flatMap((program) => {
    const vertices = program.vertices.filter((vertex) => is(program, vertex.element)).map((vertex) => vertex.id);
    return vertices.length === 0 ? [] : [{ program: program.name, vertices }];
  });
}

/** A new constructor at the end, or null when the mission has one of that name. */
export function addConstructor(mission: Mission, made: Constructor): Command | null {
  const own = ownConstructors(mission);
  if (own.some((one) => one.name === made.name)) return null;
  const after = withOwn(mission, [...own, made], ownVariables(mission));
  return commandTo(t("command.add", { name: made.name }), after);
}

/** Another one in the place of a constructor; null when it is not there or the new name is taken. */
export function changeConstructor(mission: Mission, name: string, made: Constructor): Command | null {
  const own = ownConstructors(mission);
  if (!own.some((one) => one.name === name)) return null;
  if (made.name !== name && own.some((one) => one.name === made.name)) return null;
  const list = own.map((one) => (one.name === name ? made : one));
  const after = withOwn(mission, list, ownVariables(mission));
  const rename = (element: string) => (element === name ? made.name : element);
  const programs = mission.programs.map((program) => renamed(program, rename));
  return commandTo(t("command.edit", { name }), { ...after, programs });
}

/** Without that constructor; vertices made of it stay, with the shape `unknown`. Null when it is not there. */
export function removeConstructor(mission: Mission, name: string): Command | null {
  const own = ownConstructors(mission);
  const list = own.filter((one) => one.name !== name);
  if (list.length === own.length) return null;
  return commandTo(t("command.delete", { name }), withOwn(mission, list, ownVariables(mission)));
}

/** A text of LLL in which an object has another name. */
export function renamedIn(text: string, name: string, to: string): string {
  const plain = name.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
  return text.replace(new RegExp(`(?<![\\p{L}\\p{M}\\p{N}_.])${plain}(?=\\s*\\.)`, "gu"), () => to);
}

/** Conditions of breakpoints that speak of a variable, in its new name. */
function breakpointsWith(mission: Mission, robot: string, name: string, to: string): Partial<Mission> {
  if (name === to || mission.breakpoints === undefined) return {};
  const programs = new Set(mission.programs.filter((one) => one.robot === robot).map((one) => one.name));
  const breakpoints = mission.breakpoints.map((one) =>
    one.when === undefined || !programs.has(one.program) ? one : { ...one, when: renamedIn(one.when, name, to) },
  );
  return { breakpoints };
}

function isSame(one: OwnVariable, robot: string, name: string): boolean {
  return one.robot === robot && one.variable.name === name;
}

/** A new variable at the end, or null when that robot has one of that name from this mission. */
export function addVariable(mission: Mission, made: OwnVariable): Command | null {
  const own = ownVariables(mission);
  const { name } = made.variable;
  if (own.some((one) => isSame(one, made.robot, name))) return null;
  return commandTo(t("command.add", { name }), withOwn(mission, ownConstructors(mission), [...own, made]));
}

/** Another one in the place of a variable, under its new name in every program; null when that name is taken. */
export function changeVariable(mission: Mission, robot: string, name: string, made: OwnVariable): Command | null {
  const own = ownVariables(mission);
  const { name: to } = made.variable;
  if (made.robot !== robot || !own.some((one) => isSame(one, robot, name))) return null;
  if (to !== name && own.some((one) => isSame(one, robot, to))) return null;
  const list = own.map((one) => (isSame(one, robot, name) ? made : one));
  const after = withOwn(mission, ownConstructors(mission), list);
  const rename = (element: string) => (element.startsWith(`${name}.`) ? to + element.slice(name.length) : element);
  const programs = mission.programs.map((program) => (program.robot === robot ? renamed(program, rename) : program));
  return commandTo(t(to === name ? "command.edit" : "command.rename", { name }), {
    ...after,
    programs,
    ...breakpointsWith(mission, robot, name, to),
  });
}

/** Without that variable; vertices that use it stay, with the shape `unknown`. Null when it is not there. */
export function removeVariable(mission: Mission, robot: string, name: string): Command | null {
  const own = ownVariables(mission);
  const list = own.filter((one) => !isSame(one, robot, name));
  if (list.length === own.length) return null;
  return commandTo(t("command.delete", { name }), withOwn(mission, ownConstructors(mission), list));
}
