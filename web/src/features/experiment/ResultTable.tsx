/** The numbers of a study as a table: a row for each point, whose button shows its runs. */
import type { Study } from "../../api/generated";
import { decimal, grouped } from "../../i18n/numbers";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { cellWords, measureWords, valueWords } from "./figures";
import { choosePoint, useStudy } from "./study-work";

/** Points that the table has: of more, the file tells. */
const MOST_POINTS = 500;

export function ResultTable({ study }: { study: Study }) {
  const chosen = useStudy((state) => state.point);
  const methods = new Set(study.points.flatMap(({ cells }) => cells.map(({ method }) => method)));
  methods.delete("");
  return (
    <details className="experiment-table">
      <summary>{t("experiment.table")}</summary>
      <div className="scroll-x">
        <table className="data-table nowrap small-text" data-testid="experiment-table">
          <thead>
            <tr>
              {study.axes.map(({ address }) => (
                <th key={address} scope="col" dir="ltr">
                  {address}
                </th>
              ))}
              <th scope="col">{t("experiment.table-runs")}</th>
              {study.measures.map((name) => (
                <th key={name} scope="col">
                  {measureWords(name)}
                </th>
              ))}
              <td />
            </tr>
          </thead>
          <tbody>
            {study.points.slice(0, MOST_POINTS).map((point) => (
              <tr key={point.number}>
                {point.values.map((value, at) => (
                  <td key={at}>{valueWords(value)}</td>
                ))}
                <td>{grouped(Object.values(point.outcomes).reduce((sum, one) => sum + one, 0))}</td>
                {point.cells.map((cell, at) => (
                  <td key={at}>{cellWords(cell)}</td>
                ))}
                <td>
                  <button
                    type="button"
                    className="button"
                    aria-pressed={point.number === chosen}
                    data-testid={`show-runs-${String(point.number)}`}
                    onClick={() => choosePoint(point.number)}
                  >
                    {t("experiment.show-runs")}
                  </button>
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      {study.points.length > MOST_POINTS ? (
        <p className="prose muted">
          {t("experiment.table-cut", { shown: grouped(MOST_POINTS), all: grouped(study.points.length) })}
        </p>
      ) : null}
      {methods.size === 0 ? null : (
        <p className="prose muted small-text">
          {t("experiment.methods", { confidence: decimal(100 * study.confidence) })}{" "}
          {[...methods].map((method, at) => (
            <span key={method}>
              {at > 0 ? " · " : ""}
              <Said text={method} />
            </span>
          ))}
        </p>
      )}
    </details>
  );
}
