/** What is wrong with the mission: the list, and the walk through it. */
import type { Feature } from "../../session/features";
import type { PageKey } from "../../session/key-table";
import { fixProblem, PROBLEMS, walkProblems } from "../../session/problem-walk";
import { ProblemList, ProblemsButton } from "./ProblemsButton";
import { showRunProblems } from "./run-problems";

const KEYS = {
  nextProblem: {
    chords: ["F8"],
    says: "help.keys-problem",
    also: "search.problems",
    typing: true,
    run: () => walkProblems(1),
  },
  previousProblem: {
    chords: ["Shift+F8"],
    says: "help.keys-problem",
    also: "search.problems",
    typing: true,
    run: () => walkProblems(-1),
  },
  fix: { chords: ["Ctrl+."], says: "problems.fix", also: "search.quick-fix", typing: true, run: fixProblem },
} satisfies Record<string, PageKey>;

export const problems: Feature = {
  name: "problems",
  docks: { [PROBLEMS]: ProblemList },
  slots: { bottom: ProblemsButton },
  keys: KEYS,
  start: showRunProblems,
};
