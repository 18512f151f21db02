/** The runs of the chosen point as dots over their measure: each is walked to by keys, and played. */
import { type KeyboardEvent, type MouseEvent, useMemo, useRef, useState } from "react";

import type { Study, StudyRun } from "../../api/generated";
import { Said } from "../../i18n/Said";
import { handKey } from "../../i18n/touch";
import { t } from "../../i18n/words";
import { isHeldByRobotsOrFleet } from "../../session/confirming-run";
import { useRun } from "../../session/run";
import { Button } from "../../ui/Button";
import { useWidth } from "../../ui/use-width";
import { nearest, stackRuns, ticksOf, walkDots } from "./chart";
import { figure, measureWords, pointWords } from "./figures";
import { playRow, runsOf, useStudy } from "./study-work";

const SIZE = 12;
const EDGE = 24;
const AXIS = 20;
const REACH = 24;

function runWords(study: Study, run: StudyRun, measure: number): string {
  const value = run.measures[measure];
  const said = value == null ? t("experiment.nothing") : figure(value);
  return t("experiment.run", {
    seed: String(run.seed),
    measure: measureWords(study.measures[measure] ?? ""),
    value: said,
  });
}

export function RunStrip({ study, measure }: { study: Study; measure: number }) {
  const [box, width] = useWidth<HTMLElement>(560);
  const runs = useStudy((state) => state.runs);
  const number = useStudy((state) => state.point);
  const played = useStudy((state) => state.played);
  const held = useRun(isHeldByRobotsOrFleet);
  const point = study.points.find((one) => one.number === number) ?? study.points[0];
  const own = useMemo(() => runsOf({ runs, study }, point?.number ?? 0), [runs, study, point?.number]);
  const { dots, scale, height } = useMemo(
    () => stackRuns(own, measure, { width, size: SIZE, edge: EDGE }),
    [own, measure, width],
  );
  const [place, setPlace] = useState(0);
  const at = Math.min(place, Math.max(0, dots.length - 1));
  const svg = useRef<SVGSVGElement>(null);
  if (point === undefined) return null;
  const onKeyDown = (event: KeyboardEvent) => {
    const dot = dots[at];
    if (dot !== undefined) walkDots(event, svg.current, at, () => void playRow(dot.run.row));
  };
  const onClick = (event: MouseEvent) => {
    const frame = svg.current?.getBoundingClientRect();
    const dot = nearest(dots, event.clientX - (frame?.left ?? 0), event.clientY - (frame?.top ?? 0), REACH);
    if (dot === null) return;
    setPlace(dots.indexOf(dot));
    void playRow(dot.run.row);
  };
  const current = dots[at]?.run ?? own[0];
  const words = pointWords(study, point);
  return (
    <section className="column slim gap-m" aria-label={t("experiment.runs")} ref={box}>
      <p className="prose">
        <strong>{t("experiment.runs")}</strong> {words === "" ? null : <bdi dir="ltr">{words}</bdi>}{" "}
        <span className="muted small-text">{t(handKey("experiment.how"))}</span>
      </p>
      {dots.length === 0 ? null : (
        <div className="experiment-picture slim" dir="ltr">
          <svg
            ref={svg}
            width={width}
            height={height + AXIS}
            role="group"
            aria-label={t("experiment.runs-of", { point: words })}
            data-testid="experiment-runs"
            onKeyDown={onKeyDown}
            onClick={onClick}
          >
            <g aria-hidden="true">
              {ticksOf(scale, Math.max(2, Math.floor(width / 120))).map((value) => (
                <text
                  key={value}
                  className="experiment-mark small-text figures"
                  x={scale.at(value)}
                  y={height + 16}
                  textAnchor="middle"
                >
                  {figure(value)}
                </text>
              ))}
              <path className="experiment-grid" d={`M0 ${String(height + 1)}H${String(width)}`} />
            </g>
            {dots.map(({ x, y, run }, index) => (
              <circle
                key={run.row}
                role="button"
                className="experiment-run"
                data-testid={`run-${String(run.row)}`}
                data-outcome={run.outcome}
                data-played={run.row === played}
                tabIndex={index === at ? 0 : -1}
                aria-label={`${runWords(study, run, measure)} · ${run.outcome}`}
                aria-pressed={run.row === played}
                cx={x}
                cy={y}
                r={SIZE / 2 - 1}
                onFocus={() => setPlace(index)}
              />
            ))}
          </svg>
        </div>
      )}
      {current === undefined ? null : (
        <div className="row wrap experiment-chosen" data-testid="experiment-chosen">
          <Button icon="play" testId="experiment-play" disabled={held} onClick={() => void playRow(current.row)}>
            {t("experiment.play")}
          </Button>
          <p>
            {current.row === played ? <strong>{t("sweep.plays")} </strong> : null}
            <bdi>{runWords(study, current, measure)}</bdi> ·{" "}
            <span lang="en" dir="auto">
              <Said text={current.sentence} />
            </span>
          </p>
        </div>
      )}
    </section>
  );
}
