/** How many problems there are, and the list of them behind a button. */
import { useBehind } from "../shell/checked";
import { complain } from "../shell/document";
import { later } from "../shell/later";
import { Icon } from "../theme";
import { t } from "../words/words";
import "./problems.css";
import { useProblemList, useProblems } from "./walk";

const Open = later(() => import("./ProblemList").then((chunk) => chunk.ProblemList), complain);

export function ProblemList() {
  const open = useProblemList((list) => list.open);
  if (!open) return null;
  return (
    <section className="problem-list" id="problem-list" aria-label={t("problems.title")}>
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
    <button
      type="button"
      className="problems-button"
      data-testid="problems"
      aria-expanded={open}
      aria-controls="problem-list"
      aria-busy={busy}
      title={`${t("problems.count", { count: problems.length })} (F8)`}
      onClick={() => useProblemList.setState({ open: !open })}
    >
      <Icon name={problems.length === 0 ? "circle-check" : errors ? "octagon-x" : "triangle-alert"} size={16} />
      {t("problems.title")}
      <span className="problems-count">{problems.length}</span>
    </button>
  );
}
