/** Names in the fields of a team's programs: sets of roles, groups and agents, and names of programs. */
import { TEAM_ROBOT } from "./team-robot";
import type { Catalogue, Program, Vertex } from "./types";

/** A name as it stands in a set: between double quotes where it is not made of letters and digits joined by hyphens. */
export function inSet(name: string): string {
  return /^[\p{L}_][\p{L}\p{M}\p{N}_]*(?:-[\p{L}\p{M}\p{N}_]+)*$/u.test(name)
    ? name
    : `"${name.replaceAll('"', '""')}"`;
}

const NAME = /"(?:[^"]|"")*"|[^\s{},"]+/gu;

/** The name that is written so in a set. */
function plainName(written: string): string {
  return written.startsWith('"') ? written.slice(1, -1).replaceAll('""', '"') : written;
}

/** A text of names in which one has another name. */
export function renamedInSet(text: string, name: string, to: string): string {
  return text.replace(NAME, (found) => (plainName(found) === name ? inSet(to) : found));
}

/** Where a program stands in a team's program by its name. */
export interface Call {
  program: string;
  vertex: string;
}

/** Of each program that stands in exactly one place of the team's programs by its name, that place. */
export function onlyCalls(programs: readonly Program[], catalogue: Catalogue): ReadonlyMap<string, Call> {
  const fields = namingFields(catalogue, "program");
  const found = new Map<string, Call | null>();
  for (const { name: program, robot, vertices } of programs) {
    if (robot !== TEAM_ROBOT) continue;
    for (const { id: vertex, element, settings } of vertices) {
      for (const written of (fields.get(element) ?? []).flatMap((field) => settings[field]?.match(NAME) ?? [])) {
        const called = plainName(written);
        found.set(called, found.has(called) ? null : { program, vertex });
      }
    }
  }
  return new Map([...found].flatMap(([name, call]) => (call === null ? [] : [[name, call] as const])));
}

/** Fields of elements that hold names of a kind. */
function namingFields({ groups }: Catalogue, kind: "set" | "program"): Map<string, string[]> {
  const found = new Map<string, string[]>();
  for (const { name, slots } of groups.flatMap(({ constructors }) => constructors)) {
    const fields = slots.filter((slot) => slot.names === kind).map((slot) => slot.name);
    if (fields.length > 0) found.set(name, fields);
  }
  return found;
}

/** Of each of the team's programs: vertex → the names in its sets, and in those of a program that stands there by name. */
export function actingIn(
  programs: readonly Program[],
  catalogue: Catalogue,
): ReadonlyMap<string, ReadonlyMap<string, readonly string[]>> {
  const [sets, calls] = [namingFields(catalogue, "set"), namingFields(catalogue, "program")];
  const written = ({ element, settings }: Vertex, fields: ReadonlyMap<string, string[]>) =>
    (fields.get(element) ?? []).flatMap((field) => settings[field]?.match(NAME) ?? []).map(plainName);
  const found = new Map<string, Map<string, readonly string[]>>();
  const read = (name: string): ReadonlyMap<string, readonly string[]> => {
    const known = found.get(name);
    if (known !== undefined) return known;
    const acting = new Map<string, readonly string[]>();
    // There before its calls are read: programs may stand in each other.
    found.set(name, acting);
    const program = programs.find((one) => one.name === name && one.robot === TEAM_ROBOT);
    for (const vertex of program?.vertices ?? []) {
      const called = written(vertex, calls).flatMap((inner) => [...read(inner).values()].flat());
      const names = new Set([...written(vertex, sets), ...called]);
      if (names.size > 0) acting.set(vertex.id, [...names]);
    }
    return acting;
  };
  for (const { name } of programs) read(name);
  return found;
}

/** The team's programs in which what is named in fields of that kind has another name. */
export function withNamed(
  programs: readonly Program[],
  catalogue: Catalogue,
  kind: "set" | "program",
  [name, to]: readonly [string, string],
): Program[] {
  const fields = namingFields(catalogue, kind);
  return programs.map((program) => {
    if (program.robot !== TEAM_ROBOT) return program;
    const vertices = program.vertices.map((vertex) => {
      const settings = { ...vertex.settings };
      for (const field of fields.get(vertex.element) ?? []) {
        const text = settings[field];
        if (text !== undefined) settings[field] = renamedInSet(text, name, to);
      }
      const same = Object.keys(settings).every((field) => settings[field] === vertex.settings[field]);
      return same ? vertex : { ...vertex, settings };
    });
    return vertices.every((vertex, at) => vertex === program.vertices[at]) ? program : { ...program, vertices };
  });
}
