/** How many problems there are, and the list of them behind a button. */
import { t } from "../../i18n/words";
import { useBehind } from "../../session/checked";
import { complain } from "../../session/document";
import { useProblemList, useProblems } from "../../session/problem-walk";
import { DockButton } from "../../ui/DockButton";
import { later } from "../../ui/later";
import "./problems.css";

const Open = later(() => import("./ProblemList").then((chunk) => chunk.ProblemList), complain);

export function ProblemList() {
  const open = useProblemList((list) => list.open);
  if (!open) return null;
  return (
    <section className="dock-panel column rigid" id="problem-list" aria-label={t("problems.title")}>
      <Open />
    </section>
  );
}

export function ProblemsButton() {
  const problems = useProblems();
  const open = useProblemList((list) => list.open);
  const busy = useBehind();
  const errors = problems.some((problem) => problem.severity === "error");
  return (
    <DockButton
      icon={problems.length === 0 ? "circle-check" : errors ? "octagon-x" : "triangle-alert"}
      testId="problems"
      open={open}
      panel="problem-list"
      busy={busy}
      title={`${t("problems.count", { count: problems.length })} (F8)`}
      onPress={() => useProblemList.setState({ open: !open })}
    >
      {t("problems.title")}
      <span className="muted small-text">{problems.length}</span>
    </DockButton>
  );
}
