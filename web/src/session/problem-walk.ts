/**
 * The problems in the order of the list, and the walk through them.
 *
 * Errors come first, then warnings, then hints; within one, as the server said them. What was wrong with the file when it was
 * read stands beside what is wrong with the mission now.
 */
import { useMemo } from "react";
import { create } from "zustand";

import { useStudio } from "../model/studio";
import type { Problem, Report } from "../model/types";
import { thingNamed } from "../model/world/part-reference";
import { reveal } from "./actions";
import { openDock } from "./dock";
import { useDocument } from "./document";
import { applyFix, canFix } from "./fixes";
import { useRun } from "./run";
import { openTeam, teamPlace } from "./team-view";
import { openWorld } from "./world-view";

const RANK = { error: 0, warning: 1, hint: 2 } as const;

function identity({ code, message, program, line }: Problem): string {
  return JSON.stringify([code, message, program, line]);
}

export function orderProblems(report: Report | null, others: readonly Problem[]): Problem[] {
  const found = [...(report?.problems ?? [])];
  if (others.length > 0) {
    const known = new Set(found.map(identity));
    found.push(...others.filter((problem) => known.size < known.add(identity(problem)).size));
  }
  return found.sort((a, b) => RANK[a.severity] - RANK[b.severity]);
}

/** The name of the list below the graph. */
export const PROBLEMS = "problem-list";

/** The problem that F8 is at; -1 before the first. */
export const useProblemWalk = create<{ at: number }>(() => ({ at: -1 }));

/** The walk is at that problem of the list. */
export function standAt(at: number): void {
  useProblemWalk.setState({ at });
}

/** Opens the list at its first problem. */
export function showFirstProblem(): void {
  standAt(0);
  openDock(PROBLEMS);
}

export function problemsNow(): Problem[] {
  const { files, report } = useStudio.getState();
  const others = [...useDocument.getState().fileProblems, ...useRun.getState().problems, ...files.problems];
  return orderProblems(report, others);
}

/** The same, as it changes. */
export function useProblems(): Problem[] {
  const report = useStudio((studio) => studio.report);
  const ofFile = useDocument((document) => document.fileProblems);
  const ofRun = useRun((run) => run.problems);
  const ofParts = useStudio((studio) => studio.files.problems);
  return useMemo(() => orderProblems(report, [...ofFile, ...ofRun, ...ofParts]), [report, ofFile, ofRun, ofParts]);
}

/** Shows where a problem is: the tab of its program, its vertices selected. */
export function goTo(problem: Problem): void {
  const { mission } = useStudio.getState();
  const thing = thingNamed(mission.own_world, problem.thing);
  if (thing !== null) openWorld([thing]);
  const place = teamPlace(problem, mission);
  if (place !== null) openTeam(place);
  const program = mission.programs.find((one) => one.name === problem.program);
  if (program === undefined) return;
  const ends = problem.arcs.flatMap(([from, , to]) => [from, to]);
  const wanted = problem.vertices.length > 0 ? problem.vertices : ends;
  const there = wanted.filter((id) => program.vertices.some((vertex) => vertex.id === id));
  reveal(program.name, there);
}

/** Mends the problem that the walk is at, or the first that can be mended; the walk stays where it is. */
export function fixProblem(): void {
  const problems = problemsNow();
  const current = problems[useProblemWalk.getState().at];
  const wanted = current !== undefined && canFix(current) ? current : problems.find(canFix);
  if (wanted === undefined) return;
  goTo(wanted);
  applyFix(wanted);
}

export function walkProblems(by: 1 | -1): void {
  const problems = problemsNow();
  if (problems.length === 0) return;
  const { at } = useProblemWalk.getState();
  const next = at < 0 && by < 0 ? problems.length - 1 : (at + by + problems.length) % problems.length;
  standAt(next);
  openDock(PROBLEMS);
  const problem = problems[next];
  if (problem !== undefined) goTo(problem);
}
