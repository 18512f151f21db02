/**
 * Programs that the server knows, so that of an edited one only what changed is sent, and comes back.
 *
 * A list travels as what became of another one: rows that are new things, or stretches [from, to) of the list before. What
 * stayed is told by `===`, which holds since nothing is ever changed in place. The server names the programs that it keeps; it
 * may forget them at any time (status 410), and is then sent everything.
 */
import type { Mission, Program, Report } from "../model/types";
import type { DrawnProgram, SentMission } from "./generated";

export type Rows<Thing> = (Thing | [from: number, to: number])[];

/** The newest of each name that the server has answered for. */
const known = new Map<string, { program: Program; of: string }>();

/** `after` as rows of `before`. */
export function rowsOf<Thing extends object>(before: readonly Thing[], after: readonly Thing[]): Rows<Thing> {
  const places = new Map(before.map((one, at) => [one, at]));
  const rows: Rows<Thing> = [];
  let last: [number, number] | null = null;
  for (const one of after) {
    const at = places.get(one);
    if (at === undefined) rows.push(one);
    else if (last?.[1] === at) last[1]++;
    else rows.push((last = [at, at + 1]));
    if (at === undefined) last = null;
  }
  return rows;
}

/** The list that rows of `before` say; `before` itself when that is the same. */
function taken<Thing>(before: Thing[], rows: Rows<Thing>): Thing[] {
  const after = rows.flatMap((row) => (isStretch(row) ? before.slice(...row) : [row]));
  return after.length === before.length && after.every((one, at) => one === before[at]) ? before : after;
}

function isStretch(row: unknown): row is [number, number] {
  return Array.isArray(row);
}

/** The mission as it is sent: programs as what became of those that the server knows. */
export function sent(mission: Mission): SentMission {
  return {
    ...mission,
    programs: mission.programs.map((program) => {
      const base = known.get(program.name);
      if (base === undefined) return program;
      return {
        ...program,
        of: base.of,
        vertices: rowsOf(base.program.vertices, program.vertices),
        arcs: rowsOf(base.program.arcs, program.arcs),
      };
    }),
  };
}

/** The program that came back; `before` itself when nothing in it changed. */
export function drawn(before: Program, { vertices, arcs }: DrawnProgram): Program {
  const after = { ...before, vertices: taken(before.vertices, vertices), arcs: taken(before.arcs, arcs) };
  return after.vertices === before.vertices && after.arcs === before.arcs ? before : after;
}

/** From now on the server knows these programs, by the names in its report. */
export function learn(mission: Mission, { programs }: Report): void {
  mission.programs.forEach((program, at) => {
    const of = programs[at]?.known ?? "";
    if (of === "") known.delete(program.name);
    else known.set(program.name, { program, of });
  });
}

/** The server knows nothing any more. */
export function forget(): void {
  known.clear();
}
