/** What the report says about each vertex, for badges. */
import { programInView, useStudio } from "../../model/studio";
import type { Problem, Report } from "../../model/types";

const RANK = { error: 0, warning: 1, hint: 2 };
const indexed = new WeakMap<Report, Map<string, Problem[]>>();

function byVertex(report: Report): Map<string, Problem[]> {
  let table = indexed.get(report);
  if (table !== undefined) return table;
  table = new Map();
  for (const problem of report.problems) {
    const vertices = [...problem.vertices, ...problem.arcs.map(([source]) => source)];
    for (const vertex of new Set(vertices)) {
      const key = `${problem.program}\n${vertex}`;
      table.set(
        key,
        [...(table.get(key) ?? []), problem].sort((a, b) => RANK[a.severity] - RANK[b.severity]),
      );
    }
  }
  indexed.set(report, table);
  return table;
}

const NONE: Problem[] = [];

/** Problems of a vertex of the program in view, the gravest first. */
export function useTroubles(id: string): Problem[] {
  return useStudio((state) => {
    const program = programInView(state);
    if (state.report === null || program === undefined) return NONE;
    return byVertex(state.report).get(`${program.name}\n${id}`) ?? NONE;
  });
}

/** The vertex itself if it has a problem or nothing is folded in it, else the first one inside that has. */
export function useTroubled(id: string, inside: readonly string[]): string {
  return useStudio((state) => {
    const program = programInView(state);
    if (inside.length === 0 || state.report === null || program === undefined) return id;
    const table = byVertex(state.report);
    return [id, ...inside].find((one) => table.has(`${program.name}\n${one}`)) ?? id;
  });
}
