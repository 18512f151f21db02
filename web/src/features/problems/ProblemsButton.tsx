/** How many problems there are, and the list of them behind a button. */
import { DockButton } from "../../components/DockButton";
import { t } from "../../i18n/words";
import { useBehind } from "../../session/checked";
import { complain } from "../../session/document";
import { PROBLEMS, useProblems } from "../../session/problem-walk";
import { later } from "../../ui/later";
import "./problems.css";

const Open = later(() => import("./ProblemList").then((chunk) => chunk.ProblemList), complain);

export function ProblemList() {
  return (
    <section className="dock-panel column rigid" id={PROBLEMS} aria-label={t("problems.title")}>
      <Open />
    </section>
  );
}

export function ProblemsButton() {
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
