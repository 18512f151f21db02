/**
 * Programs that the server knows, so that of an edited one only what changed is sent, and comes back.
 *
 * A list travels as what became of another one: rows that are new things, or stretches [from, to) of the list before. What
 * stayed is told by `===`, which holds since nothing is ever changed in place. The server names the programs that it keeps; it
 * may forget them at any time (status 410), and is then sent everything.
 */
import type { Mission, Program, ProgramReport, Report, SpanEntry } from "../model/types";
import { unitsOf } from "../model/units";
import type { DrawnProgram, Moved, ProgramReportChange, SentMission, Report as Told } from "./generated";

export type Rows<Thing> = (Thing | [from: number, to: number])[];

/** The newest of each name that the server has answered for. */
const known = new Map<string, Known>();

interface Known {
  program: Program;
  of: string;
  report: ProgramReport;
}

/** What the server knew when it was asked. */
export type Bases = ReadonlyMap<string, Known>;

export function bases(): Bases {
  return new Map(known);
}

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

function isMoved(row: SpanEntry | Moved): row is Moved {
  return "characters" in row;
}

function moved(before: readonly SpanEntry[], { start, end, characters, lines }: Moved): SpanEntry[] {
  const stretch = before.slice(start, end);
  if (characters === 0 && lines === 0) return stretch;
  return stretch.map((one) => ({
    vertex: one.vertex,
    start: one.start + characters,
    end: one.end + characters,
    line: one.line + lines,
  }));
}

function changed(before: ProgramReport, change: ProgramReportChange): ProgramReport {
  const { name, at, removed, inserted, instructions, known: named } = change;
  // Places count whole characters, of which some are two units.
  const units = unitsOf(before.lll);
  const [from, to] = [units(at), units(at + removed)];
  return {
    name,
    lll: before.lll.slice(0, from) + inserted + before.lll.slice(to),
    spans: change.spans.flatMap((row) => (isMoved(row) ? moved(before.spans, row) : [row])),
    instructions,
    known: named,
  };
}

/** A report with each program whole. */
export function whole(told: Told, before: Bases): Report {
  const programs = told.programs.map((one) => {
    if (!("of" in one)) return one;
    const base = before.get(one.name);
    if (base?.of !== one.of) throw new Error(`nothing is known of ${one.of}`);
    return changed(base.report, one);
  });
  return { ...told, programs };
}

/** From now on the server knows these programs, by the names in its report. */
export function learn(mission: Mission, { programs }: Report): void {
  mission.programs.forEach((program, at) => {
    const report = programs[at];
    if (report === undefined || report.known === "") known.delete(program.name);
    else known.set(program.name, { program, of: report.known, report });
  });
}

/** The server knows nothing any more. */
export function forget(): void {
  known.clear();
}
