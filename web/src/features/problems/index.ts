/** What is wrong with the mission: the list, and the walk through it. */
import type { Feature } from "../../session/features";
import { fixProblem, PROBLEMS, walkProblems } from "../../session/problem-walk";
import { ProblemList, ProblemsButton } from "./ProblemsButton";
import { showRunProblems } from "./run-problems";

export const problems: Feature = {
  name: "problems",
  docks: { [PROBLEMS]: ProblemList },
  slots: { bottom: ProblemsButton },
  commands: {
    nextProblem: () => walkProblems(1),
    previousProblem: () => walkProblems(-1),
    fix: fixProblem,
  },
  start: showRunProblems,
};
