/** The table of answers: a grid that keys walk in; a broken one opens its run. */
import { useEffect } from "react";

import type { CheckedProperty, VerifyColumnMessage } from "../../api/generated";
import { decimal, grouped } from "../../i18n/numbers";
import { t } from "../../i18n/words";
import { Said } from "../../i18n/Said";
import { cellName, useGridWalk } from "../../ui/use-grid-walk";
import { USUAL, withKinds } from "./kinds";
import { type Assumption, type Cell, columnAt, sameAssumption, type Shape, shapeOf } from "./table";
import { openAnswer, useCheck } from "./check-session";

function stepsWords({ steps, repeats_from: from }: CheckedProperty): string {
  const words = t("check.steps", { count: from < 0 ? steps : from });
  return from < 0 ? words : t("check.steps-then", { steps: words });
}

/** The second line of an answer. */
function detail(answer: CheckedProperty | undefined): string {
  return answer?.answer !== "broken" ? "" : stepsWords(answer);
}

/** How many states a rough search may have missed. */
function oddsWords(odds: number): string {
  if (odds > WORTHLESS) return t("check.odds-full");
  return t("check.odds", { states: grouped(Math.round(1 / Math.max(odds, LEAST_ODDS))) });
}

function Mark({ shape }: { shape: Shape }) {
  return <span className="check-mark rigid relative text-centre" data-shape={shape} aria-hidden="true" />;
}

/** Odds from which on a rough search says next to nothing, and the smallest that are told. */
const WORTHLESS = 0.5;
const LEAST_ODDS = 1e-9;

interface HeadProps {
  assumption: Assumption;
  column: VerifyColumnMessage | undefined;
  now: boolean;
}

function Head({ assumption, column, now }: HeadProps) {
  const { timing, failures } = assumption;
  const kinds = useCheck((check) => check.asked?.kinds) ?? USUAL;
  return (
    <th scope="col" data-now={now}>
      <span className="check-timing">{t(`check.${timing}`)}</span>
      <span className="check-means muted block tiny-text">
        {failures === 0 ? t(`check.${timing}-means`) : withKinds(t("check.head-failures", { count: failures }), kinds)}
      </span>
      {column === undefined ? null : (
        <span className="check-means figures muted block tiny-text">
          {t("check.explored", {
            states: grouped(column.states),
            seconds: decimal(Math.round(column.seconds * 10) / 10),
          })}
        </span>
      )}
      {column === undefined || column.cut === null ? null : (
        <span className="check-means muted block tiny-text" data-testid={`cut-${timing}-${String(failures)}`}>
          {t(`check.cut-${column.cut}`)}
        </span>
      )}
      {column === undefined || column.odds === null ? null : (
        <span className="check-means muted block tiny-text" data-testid={`odds-${timing}-${String(failures)}`}>
          {oddsWords(column.odds)}
        </span>
      )}
    </th>
  );
}

export function AnswerTable() {
  const plan = useCheck((check) => check.plan);
  const columns = useCheck((check) => check.columns);
  const busy = useCheck((check) => check.busy);
  const progress = useCheck((check) => check.progress);
  const open = useCheck((check) => check.open);
  const rows = columns[0]?.properties ?? [];
  const found = plan.map((_, place) => columnAt(plan, columns, place));

  const choose = (cell: Cell) => {
    const answer = found[cell.column]?.properties[cell.row];
    openAnswer(answer?.answer === "broken" ? cell : null);
  };
  const { at, table } = useGridWalk({ row: rows.length, column: plan.length }, choose);

  useEffect(() => {
    // The table is narrower beside a run. Not returned: newer browsers give a promise.
    table.ref.current?.querySelector('[aria-selected="true"]')?.scrollIntoView({ block: "nearest", inline: "nearest" });
  }, [open, table.ref]);

  return (
    <div className="scroll-x rigid">
      <table
        className="check-table data-table small-text"
        role="grid"
        aria-label={t("check.table")}
        data-testid="check-table data-table"
        {...table}
      >
        <thead>
          <tr>
            <th scope="col">{t("check.property")}</th>
            {plan.map((assumption, place) => (
              <Head
                key={place}
                assumption={assumption}
                column={found[place]}
                now={busy && progress !== null && sameAssumption(assumption, progress)}
              />
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map(({ name, sentence }, row) => (
            <tr key={name}>
              <th scope="row" title={name}>
                <span className="check-sentence block">
                  <Said text={sentence} />
                </span>
              </th>
              {plan.map((assumption, column) => {
                const answer = found[column]?.properties[row];
                const now = progress !== null && sameAssumption(assumption, progress);
                const shape = shapeOf(answer, busy, now);
                return (
                  <td
                    key={column}
                    className="check-answer nowrap"
                    data-cell={cellName({ row, column })}
                    data-testid={`answer-${name}-${assumption.timing}-${String(assumption.failures)}`}
                    data-shape={shape}
                    tabIndex={at.row === row && at.column === column ? 0 : -1}
                    aria-selected={open?.row === row && open.column === column}
                  >
                    <span className="check-word row">
                      <Mark shape={shape} />
                      {t(`check.is-${shape}`)}
                    </span>
                    <span className="check-detail muted block tiny-text">{detail(answer)}</span>
                  </td>
                );
              })}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
