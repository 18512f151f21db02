/**
 * What may stand next in a condition that says whose its tests are: `any carrier-1 (Cargo.IsPressed())`.
 *
 * A guess from the text before the caret, no parser: whoever types something else is told by the server.
 */
import type { Catalogue, Mission } from "../../model/types";

export interface Suggestion {
  /** What is inserted in the place of what was begun. */
  text: string;
  /** Where that begins. */
  from: number;
}

const QUANTIFIERS = ["any", "all", "most"];
const MOST = 8;

function written(name: string): string {
  return /^[\p{L}_][\p{L}\p{M}\p{N}_]*(-[\p{L}\p{M}\p{N}_]+)*$/u.test(name) ? name : `"${name.replaceAll('"', '""')}"`;
}

/** Agents, the programs that they run, and the roles and groups of the team. */
function names({ agents, roles, groups }: Mission): string[] {
  const own = [...agents.map(({ name }) => name), ...agents.map(({ program }) => program)];
  return [...new Set([...own, ...[...(roles ?? []), ...(groups ?? [])].map(({ name }) => name)])].map(written);
}

/** The kinds of robots that a name stands for: of a group, those of its members. */
function kindsOf(mission: Mission, name: string, seen: readonly string[] = []): (string | undefined)[] {
  if (seen.includes(name)) return [];
  const agents = mission.agents
    .filter((agent) => agent.name === name || agent.program === name)
    .map(({ robot, program }) => robot || mission.programs.find((one) => one.name === program)?.robot);
  const roles = (mission.roles ?? []).filter((role) => role.name === name).map(({ robot }) => robot);
  const members = (mission.groups ?? []).filter((group) => group.name === name).flatMap((group) => group.members);
  return [...agents, ...roles, ...members.flatMap((member) => kindsOf(mission, member, [...seen, name]))];
}

/** The tests of the robots that a name stands for, and of the team's works, as they are written. */
function tests(mission: Mission, catalogue: Catalogue, name: string): string[] {
  const kinds = new Set(kindsOf(mission, name.replace(/^"|"$/g, "").replaceAll('""', '"')));
  const { work } = catalogue;
  const works = work == null ? [] : (mission.works ?? []).map((one) => ({ ...work, name: one.name }));
  const parts = catalogue.robots.filter((robot) => kinds.has(robot.name)).flatMap(({ objects }) => objects);
  const readable = parts.filter(({ category }) => category === "sensor" || category === "variable");
  const found = [...readable, ...(kinds.size > 0 ? works : [])].flatMap(({ name: part, methods }) =>
    methods
      .filter(({ kind }) => kind === "test")
      .map((method) => `${part}.${method.name}(${method.parameters.map(() => "1").join(", ")})`),
  );
  return [...new Set(found)];
}

/** What may stand at the end of this text; nothing where it is not known. */
export function suggest(before: string, mission: Mission, catalogue: Catalogue | null): Suggestion[] {
  const fits = (words: readonly string[], begun: string, behind = "") =>
    words
      .filter((word) => word.toLowerCase().startsWith(begun.toLowerCase()) && word + behind !== begun)
      .slice(0, MOST)
      .map((word) => ({ text: word + behind, from: before.length - begun.length }));
  const inside =
    /(?:any|all|most)\s+(?:\{\s*)?("[^"]*"|[^\s(){},"]+)[^()]*\((?:.*[&|(\s])?([\p{L}\p{M}\p{N}_.]*)$/u.exec(
      openPart(before),
    );
  if (inside !== null)
    return catalogue === null ? [] : fits(tests(mission, catalogue, inside[1] ?? ""), inside[2] ?? "");
  const member = /(?:^|[\s(!&|])(?:any|all|most)\s+(?:\{(?:[^}]*,)?\s*)?("?[^\s(){},"]*)$/u.exec(before);
  if (member !== null) return fits(names(mission), member[1] ?? "", " (");
  const word = /(?:^|[\s(!&|])([a-z]*)$/.exec(before);
  return word === null || /\)\s*$/.test(before) ? [] : fits(QUANTIFIERS, word[1] ?? "", " ");
}

/** The text from the last quantifier on whose bracket is open. */
function openPart(before: string): string {
  const starts = [...before.matchAll(/(?:^|[\s(!&|])((?:any|all|most)\s)/g)];
  const start = starts.at(-1);
  if (start === undefined) return "";
  const part = before.slice(start.index);
  const count = (sign: string) => part.split(sign).length - 1;
  return count("(") > count(")") ? part.replace(/^[^a-z]*/, "") : "";
}
