/** The map itself: a grid of fields that keys walk in and that plays whichever is chosen, with its legend above. */
import { memo, useMemo } from "react";

import type { SweepField } from "../../api/generated";
import { axisTime, clock, grouped } from "../../i18n/numbers";
import { Said } from "../../i18n/Said";
import { handKey } from "../../i18n/touch";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { isHeldByRobotsOrFleet } from "../../session/confirming-run";
import { useRun } from "../../session/run";
import { Button } from "../../ui/Button";
import { cellName, useGridWalk } from "../../ui/use-grid-walk";
import { countsOf, ENDINGS, rowsOf, SIGNS } from "./map";
import { play, type Swept, useSweep } from "./sweep-session";

/** Of so many columns one has its time above it. */
const EACH = 4;

function said(agent: string, at_s: number, field: SweepField | null): string {
  const time = clock(at_s);
  if (field === null) return t("sweep.cell", { agent, time, outcome: t("sweep.none") });
  return t("sweep.cell-end", { agent, time, outcome: t(`sweep.${field.outcome}`), end: clock(field.seconds) });
}

interface RowProps {
  agent: string;
  at: number;
  moments: readonly number[];
  fields: readonly (SweepField | null)[];
  /** The moments of the fields here that the keys are at and that was played; -1 where they are in another row. */
  current: number;
  played: number;
}

const Row = memo(function Row({ agent, at, moments, fields, current, played }: RowProps) {
  return (
    <tr>
      <th scope="row">
        <bdi>{agent}</bdi>
      </th>
      {fields.map((field, moment) => {
        const label = said(agent, moments[moment] ?? 0, field);
        const ending = field?.outcome ?? "none";
        return (
          <td
            key={moment}
            className="sweep-field justify-centre"
            data-ending={ending}
            data-cell={cellName({ row: at, column: moment })}
            data-testid={`field-${String(at)}-${String(moment)}`}
            data-played={moment === played}
            tabIndex={moment === current ? 0 : -1}
            title={label}
            aria-label={label}
            aria-selected={moment === played}
          >
            {SIGNS[ending]}
          </td>
        );
      })}
    </tr>
  );
});

export function SweepMap({ swept }: { swept: Swept }) {
  const { map, asked } = swept;
  const rows = useMemo(() => rowsOf(map), [map]);
  const counts = useMemo(() => countsOf(map), [map]);
  const size = { row: map.agents.length, column: map.moments.length };
  const { at: cell, table } = useGridWalk(size, ({ row, column }) => play({ agent: row, moment: column }));
  const at = { agent: cell.row, moment: cell.column };
  const played = useSweep((sweep) => sweep.played);
  const held = useRun(isHeldByRobotsOrFleet);
  const changed = useStudio(({ mission }) => mission !== asked.mission);
  const field = rows[at.agent]?.[at.moment] ?? null;

  return (
    <div className="column slim gap-m">
      <p className="prose muted">
        {t("sweep.baseline")} <Said text={map.sentence} />
      </p>
      {changed ? <p className="sweep-warning prose warning">{t("sweep.changed")}</p> : null}
      {held ? <p className="sweep-warning prose warning">{t("sweep.real")}</p> : null}
      {counts.none > 0 ? (
        <p className="sweep-warning prose warning">
          {t("sweep.cut", { done: grouped(map.fields.length), total: grouped(map.total) })}
        </p>
      ) : null}
      <ul className="sweep-legend wrap flex gap-2xl" data-testid="sweep-legend">
        {ENDINGS.filter((ending) => ending === "done" || counts[ending] > 0).map((ending) => (
          <li key={ending} data-testid={`sweep-count-${ending}`}>
            <span className="sweep-field justify-centre" data-ending={ending} aria-hidden="true">
              {SIGNS[ending]}
            </span>
            {t(`sweep.${ending}`)} <strong>{grouped(counts[ending])}</strong>
          </li>
        ))}
        {counts.done === map.total ? <li className="bold">{t("sweep.all-done")}</li> : null}
      </ul>
      <p className="prose muted" id="sweep-how">
        {t(handKey("sweep.how"))}
      </p>
      <div className="scroll-x">
        <table
          className="sweep-map small-text"
          role="grid"
          aria-label={t("sweep.map")}
          aria-describedby="sweep-how"
          data-testid="sweep-map"
          {...table}
        >
          <thead>
            <tr>
              <th className="nowrap" scope="col">
                <span className="only-spoken">{t("sweep.robot")}</span>
              </th>
              {map.moments.map((moment, index) => (
                <th className="nowrap" key={moment} scope="col">
                  <span className={index % EACH === 0 ? "sweep-moment figures" : "only-spoken"}>
                    {axisTime(moment)}
                  </span>
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.map((fields, agent) => (
              <Row
                key={agent}
                agent={map.agents[agent] ?? ""}
                at={agent}
                moments={map.moments}
                fields={fields}
                current={at.agent === agent ? at.moment : -1}
                played={played?.agent === agent ? played.moment : -1}
              />
            ))}
          </tbody>
        </table>
      </div>
      <div className="sweep-chosen row wrap" data-testid="sweep-chosen">
        <Button icon="play" testId="sweep-play" disabled={held} onClick={() => play(at)}>
          {t("sweep.play")}
        </Button>
        <p>
          {played?.agent === at.agent && played.moment === at.moment ? <strong>{t("sweep.plays")} </strong> : null}
          <bdi>{said(map.agents[at.agent] ?? "", map.moments[at.moment] ?? 0, field)}</bdi>
          {field === null ? null : (
            <>
              {" · "}
              <Said text={field.sentence} />
            </>
          )}
        </p>
      </div>
    </div>
  );
}
