/** A measure over two axes as a map, and over three as a map for each value of the first. */
import { useMemo } from "react";

import type { Study, StudyPoint } from "../../api/generated";
import { t } from "../../i18n/words";
import { cellName, useGridWalk } from "../../ui/use-grid-walk";
import { shareOf, variedAxes } from "./chart";
import { cellWords, figure, measureWords, pointWords, valueWords } from "./figures";
import { choosePoint, playRow, useStudy } from "./study-work";

interface Props {
  study: Study;
  measure: number;
}

export function StudyMaps({ study, measure }: Props) {
  const varied = variedAxes(study);
  const [rows = 0, columns = 0] = varied.slice(-2);
  const third = varied.length > 2 ? varied[0] : undefined;
  const values = third === undefined ? [undefined] : (study.axes[third]?.values ?? []);
  return (
    <div className="experiment-maps wrap flex gap-2xl">
      {values.map((value, at) => (
        <StudyMap
          key={at}
          study={study}
          measure={measure}
          rows={rows}
          columns={columns}
          caption={value === undefined ? "" : `${study.axes[third ?? 0]?.address ?? ""} = ${valueWords(value)}`}
          holds={(point) => third === undefined || point.values[third] === value}
        />
      ))}
    </div>
  );
}

interface MapProps extends Props {
  rows: number;
  columns: number;
  caption: string;
  holds: (point: StudyPoint) => boolean;
}

function StudyMap({ study, measure, rows, columns, caption, holds }: MapProps) {
  const chosen = useStudy((state) => state.point);
  const down = study.axes[rows];
  const across = study.axes[columns];
  const size = { row: down?.values.length ?? 0, column: across?.values.length ?? 0 };
  const share = useMemo(() => shareOf(study, measure), [study, measure]);
  const cells = new Map(
    study.points.filter(holds).map((point) => [JSON.stringify([point.values[rows], point.values[columns]]), point]),
  );
  const pointAt = (row: number, column: number) =>
    cells.get(JSON.stringify([down?.values[row], across?.values[column]]));
  const { at, table } = useGridWalk(size, ({ row, column }) => {
    const point = pointAt(row, column);
    if (point === undefined) return;
    choosePoint(point.number);
    if (study.seeds === 1) void playRow(point.number);
  });
  const name = measureWords(study.measures[measure] ?? "");
  const about = t("experiment.map", { measure: name, rows: down?.address ?? "", columns: across?.address ?? "" });
  return (
    <div>
      <table
        className="experiment-map small-text"
        role="grid"
        aria-label={caption === "" ? about : `${caption}: ${about}`}
        data-testid="experiment-map"
        {...table}
      >
        <caption dir="ltr">
          {caption === "" ? null : <strong>{caption} </strong>}
          <span className="muted">
            {down?.address} ↓ {across?.address} →
          </span>
        </caption>
        <thead>
          <tr>
            <td />
            {across?.values.map((value) => (
              <th key={value} scope="col">
                {valueWords(value)}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {down?.values.map((value, row) => (
            <tr key={value}>
              <th scope="row">{valueWords(value)}</th>
              {across?.values.map((other, column) => {
                const point = pointAt(row, column);
                const estimate = point?.cells[measure]?.estimate ?? null;
                const words =
                  point === undefined
                    ? t("experiment.not-run")
                    : `${pointWords(study, point)}: ${cellWords(point.cells[measure])}`;
                return (
                  <td
                    key={other}
                    className="experiment-field figures text-centre"
                    data-cell={cellName({ row, column })}
                    data-testid={point === undefined ? undefined : `point-${String(point.number)}`}
                    tabIndex={at.row === row && at.column === column ? 0 : -1}
                    aria-label={words}
                    title={words}
                    aria-selected={point !== undefined && point.number === chosen}
                    style={{ "--share": String(share(point) ?? 0) } as React.CSSProperties}
                  >
                    {estimate === null ? "" : figure(estimate)}
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
