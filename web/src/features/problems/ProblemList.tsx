/** The list of problems above the bottom bar, a piece of it at a time; fetched when it is opened first. */
import { useEffect, useRef, useState } from "react";

import { DockHead } from "../../components/DockPanel";
import { grouped } from "../../i18n/numbers";
import { Said } from "../../i18n/Said";
import { sentence, t } from "../../i18n/words";
import type { Problem } from "../../model/types";
import { isHeldByRobots, runOf } from "../../session/confirming-run";
import { applyFix, canFix } from "../../session/fixes";
import { goTo, standAt, useProblems, useProblemWalk } from "../../session/problem-walk";
import { useRun } from "../../session/run";
import { Icon } from "../../theme";

/** Mends the problem that F8 is at. */
const FIX_KEY = "Ctrl+.";
/** So many rows come at once: a file can have a problem in each of its lines. */
const ROWS = 200;
const SHAPES = { error: "octagon-x", warning: "triangle-alert", hint: "lightbulb" } as const;

function Row({ problem, index, at }: { problem: Problem; index: number; at: number }) {
  const button = useRef<HTMLButtonElement>(null);
  const current = index === at;
  useEffect(() => {
    if (current) button.current?.scrollIntoView({ block: "nearest" });
  }, [current]);
  const play = runOf(problem);
  const held = useRun(isHeldByRobots);
  const place = problem.program !== "" ? problem.program : (problem.file.split(/[\\/]/).at(-1) ?? "");
  return (
    <li className="problem-row aligned">
      <button
        type="button"
        ref={button}
        className="problem flex start-text focus-inside items-start"
        data-testid={`problem-${String(index + 1)}`}
        aria-current={current}
        onClick={() => {
          standAt(index);
          goTo(problem);
        }}
      >
        <Icon
          name={SHAPES[problem.severity]}
          size={16}
          label={t(`problems.${problem.severity}`)}
          className={`problem-${problem.severity}`}
        />
        <span className="grow">
          <span className="block">
            <Said text={sentence(problem.message)} />
          </span>
          {problem.help === "" ? null : (
            <span className="problem-help muted small-text block">
              <Said text={sentence(problem.help)} />
            </span>
          )}
        </span>
        <span className="problem-place muted small-text">
          {place}
          {problem.line > 0 ? `:${String(problem.line)}` : ""}
        </span>
        <code className="problem-code muted code-text">{problem.code}</code>
      </button>
      {play === null ? null : (
        <button
          type="button"
          className="button problem-fix"
          data-testid={`show-${String(index + 1)}`}
          disabled={held}
          title={held ? t("check.real") : undefined}
          aria-label={t("problems.show-run-of", { message: sentence(problem.message) })}
          onClick={() => {
            goTo(problem);
            play();
          }}
        >
          <Icon name="play" size={14} />
          {t("problems.show-run")}
        </button>
      )}
      {canFix(problem) ? (
        <button
          type="button"
          className="button problem-fix"
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
  const at = useProblemWalk((walk) => walk.at);
  const [shown, setShown] = useState(ROWS);
  const count = Math.max(shown, Math.ceil((at + 1) / ROWS) * ROWS);
  const left = problems.length - count;
  return (
    <>
      <DockHead
        title={problems.length === 0 ? t("problems.title") : t("problems.count", { count: problems.length })}
        close={t("problems.close")}
      />
      {problems.length === 0 ? (
        <p className="dock-none muted">{t("problems.none")}</p>
      ) : (
        <ol>
          {problems.slice(0, count).map((problem, index) => (
            <Row key={`${problem.code} ${String(index)}`} problem={problem} index={index} at={at} />
          ))}
          {left > 0 ? (
            <li>
              <button type="button" className="problem-more hover" onClick={() => setShown(count + ROWS)}>
                {t("problems.more", { count: Math.min(ROWS, left), all: grouped(left) })}
              </button>
            </li>
          ) : null}
        </ol>
      )}
    </>
  );
}
