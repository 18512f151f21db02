/** What is wrong with the mission: the list, and the walk through it. */
import "./problems.css";

import { DockButton } from "../../components/DockButton";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { useBehind } from "../../session/report";
import { reportError } from "../../session/document";
import type { Feature } from "../../session/features";
import type { PageKey } from "../../session/key-table";
import { fixProblem, PROBLEMS, showFirstProblem, useProblems, walkProblems } from "../../session/problem-walk";
import { forgetRunProblems, useRun } from "../../session/run";
import { endAll } from "../../ui/effects";
import { later } from "../../ui/later";

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

/** Watches for it; the returned function ends that. */
function showRunProblems(): () => void {
  const offRun = useRun.subscribe((run, before) => {
    if (run.problems !== before.problems && run.problems.length > 0) showFirstProblem();
  });
  const offMission = useStudio.subscribe((state, before) => {
    if (state.mission !== before.mission) forgetRunProblems();
  });
  return endAll(offRun, offMission);
}

const Open = later(() => import("./ProblemList").then((chunk) => chunk.ProblemList), reportError);

function ProblemList() {
  return (
    <section className="dock-panel column rigid" id={PROBLEMS} aria-label={t("problems.title")}>
      <Open />
    </section>
  );
}

/** How many problems there are, and the list of them behind a button. */
function ProblemsButton() {
  const problems = useProblems();
  const busy = useBehind();
  const errors = problems.some((problem) => problem.severity === "error");
  return (
    <DockButton
      icon={problems.length === 0 ? "circle-check" : errors ? "octagon-x" : "triangle-alert"}
      testId="problems"
      panel={PROBLEMS}
      busy={busy}
      title={`${t("problems.count", { count: problems.length })} (F8)`}
    >
      {t("problems.title")}
      <span className="muted small-text">{problems.length}</span>
    </DockButton>
  );
}

export const problems: Feature = {
  name: "problems",
  docks: { [PROBLEMS]: ProblemList },
  slots: { bottom: ProblemsButton },
  keys: KEYS,
  start: showRunProblems,
};
