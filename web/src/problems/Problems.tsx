/** The list of problems above the bottom bar, and the button that opens it. */
import { useEffect, useMemo, useRef } from "react";

import type { Problem } from "../api/types";
import { useStudio } from "../model/studio";
import { useRun } from "../run/run";
import { useBehind } from "../shell/checked";
import { useDocument } from "../shell/document";
import { Icon } from "../theme";
import { Said } from "../words/Said";
import { sentence, t } from "../words/words";
import "./problems.css";
import { applyFix, canFix } from "./fixes";
import { goTo, orderProblems, useProblemList } from "./walk";

/** Mends the problem that F8 is at. */
export const FIX_KEY = "Ctrl+.";

const SHAPES = { error: "octagon-x", warning: "triangle-alert", hint: "lightbulb" } as const;

function useProblems(): Problem[] {
  const report = useStudio((studio) => studio.report);
  const ofFile = useDocument((document) => document.fileProblems);
  const ofRun = useRun((run) => run.problems);
  const ofParts = useStudio((studio) => studio.files.problems);
  return useMemo(() => orderProblems(report, [...ofFile, ...ofRun, ...ofParts]), [report, ofFile, ofRun, ofParts]);
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

function Row({ problem, index, at }: { problem: Problem; index: number; at: number }) {
  const button = useRef<HTMLButtonElement>(null);
  const current = index === at;
  useEffect(() => {
    if (current) button.current?.scrollIntoView({ block: "nearest" });
  }, [current]);
  const place = problem.program !== "" ? problem.program : (problem.file.split(/[\\/]/).at(-1) ?? "");
  return (
    <li className="problem-row">
      <button
        type="button"
        ref={button}
        className="problem"
        data-testid={`problem-${String(index + 1)}`}
        aria-current={current}
        onClick={() => {
          useProblemList.setState({ at: index });
          goTo(problem);
        }}
      >
        <Icon
          name={SHAPES[problem.severity]}
          size={16}
          label={t(`problems.${problem.severity}`)}
          className={`problem-${problem.severity}`}
        />
        <span className="problem-words">
          <span className="problem-message">
            <Said text={sentence(problem.message)} />
          </span>
          {problem.help === "" ? null : (
            <span className="problem-help">
              <Said text={sentence(problem.help)} />
            </span>
          )}
        </span>
        <span className="problem-place">
          {place}
          {problem.line > 0 ? `:${String(problem.line)}` : ""}
        </span>
        <code className="problem-code">{problem.code}</code>
      </button>
      {canFix(problem) ? (
        <button
          type="button"
          className="problem-fix"
          data-testid={`fix-${String(index + 1)}`}
          title={`${t("problems.fix")} (${FIX_KEY})`}
          aria-label={t("problems.fix-this", { message: sentence(problem.message) })}
          onClick={() => applyFix(problem)}
        >
          <Icon name="wrench" size={14} />
          {t("problems.fix")}
        </button>
      ) : null}
    </li>
  );
}

export function ProblemList() {
  const problems = useProblems();
  const { open, at } = useProblemList();
  if (!open) return null;
  return (
    <section className="problem-list" id="problem-list" aria-label={t("problems.title")}>
      <header className="problem-head">
        <h2>{problems.length === 0 ? t("problems.title") : t("problems.count", { count: problems.length })}</h2>
        <button
          type="button"
          className="tool small"
          aria-label={t("problems.close")}
          onClick={() => useProblemList.setState({ open: false })}
        >
          <Icon name="x" size={16} />
        </button>
      </header>
      {problems.length === 0 ? (
        <p className="problem-none">{t("problems.none")}</p>
      ) : (
        <ol>
          {problems.map((problem, index) => (
            <Row key={`${problem.code} ${String(index)}`} problem={problem} index={index} at={at} />
          ))}
        </ol>
      )}
    </section>
  );
}
