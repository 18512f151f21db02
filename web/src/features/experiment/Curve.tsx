/** A measure over one axis: means with their intervals, and each run as a dot behind them. */
import { type KeyboardEvent, memo, type MouseEvent, useMemo, useRef, useState } from "react";

import type { Study } from "../../api/generated";
import { t } from "../../i18n/words";
import { useWidth } from "../../ui/use-width";
import { curveOf, type Dot, nearest, walkDots } from "./chart";
import { cellWords, figure, measureWords, pointWords, valueWords } from "./figures";
import { choosePoint, isSmall, playRow, useStudy } from "./study-work";

const [LEAST_HEIGHT, MOST_HEIGHT] = [220, 320];
/** Its height, of its width. */
const SHAPE = 0.42;
const FRAME = { left: 56, top: 10 };
const [RIGHT, BELOW] = [16, 40];
/** How far from a dot a press still means it. */
const REACH = 16;

interface Props {
  study: Study;
  axis: number;
  measure: number;
  /** Whether neighbours are joined by a line. */
  joined: boolean;
}

export function Curve({ study, axis, measure, joined }: Props) {
  const [box, width] = useWidth<HTMLDivElement>(560);
  const runs = useStudy((state) => state.runs);
  const chosen = useStudy((state) => state.point);
  const height = Math.round(Math.min(MOST_HEIGHT, Math.max(LEAST_HEIGHT, SHAPE * width)));
  const curve = useMemo(
    () =>
      curveOf(study, {
        axis,
        measure,
        runs: isSmall(study) ? runs : [],
        frame: { ...FRAME, right: width - RIGHT, bottom: height - BELOW },
      }),
    [study, axis, measure, runs, width, height],
  );
  const [at, setAt] = useState(0);
  const svg = useRef<SVGSVGElement>(null);
  const { means } = curve;
  const choose = (point: number) => {
    choosePoint(point);
    if (study.seeds === 1) void playRow(point);
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const mean = means[at];
    if (mean !== undefined) walkDots(event, svg.current, at, () => choose(mean.point.number));
  };
  const onClick = (event: MouseEvent) => {
    const frame = svg.current?.getBoundingClientRect();
    const [x, y] = [event.clientX - (frame?.left ?? 0), event.clientY - (frame?.top ?? 0)];
    const dot = nearest(curve.dots, x, y, REACH);
    const mean = nearest(means, x, y, REACH);
    const isMean =
      mean !== null && (dot === null || Math.hypot(mean.x - x, mean.y - y) <= Math.hypot(dot.x - x, dot.y - y));
    if (isMean) choose(mean.point.number);
    else if (dot !== null) {
      choosePoint(Math.floor(dot.run.row / study.seeds));
      void playRow(dot.run.row);
    }
  };
  const name = measureWords(study.measures[measure] ?? "");
  const address = study.axes[axis]?.address ?? "";
  return (
    <div className="experiment-picture slim" ref={box} dir="ltr">
      <svg
        ref={svg}
        className="experiment-curve"
        width={width}
        height={height}
        role="group"
        aria-label={t("experiment.curve", { measure: name, address })}
        data-testid="experiment-curve"
        onKeyDown={onKeyDown}
        onClick={onClick}
      >
        <g aria-hidden="true">
          {curve.ys.map(({ at: y, value }) => (
            <g key={value}>
              <path className="experiment-grid" d={`M${String(FRAME.left)} ${String(y)}H${String(width - RIGHT)}`} />
              <text className="experiment-mark small-text figures" x={FRAME.left - 8} y={y + 4} textAnchor="end">
                {figure(value)}
              </text>
            </g>
          ))}
          {curve.xs.map(({ at: x, value }) => (
            <text key={value} className="experiment-mark small-text figures" x={x} y={height - 22} textAnchor="middle">
              {valueWords(value)}
            </text>
          ))}
          <text
            className="experiment-mark small-text figures"
            x={(FRAME.left + width - RIGHT) / 2}
            y={height - 4}
            textAnchor="middle"
          >
            {address}
          </text>
          {joined && means.length > 1 ? (
            <>
              <path
                className="experiment-band"
                d={`M${means.map(({ x, high }) => `${String(x)} ${String(high)}`).join("L")}L${[...means]
                  .reverse()
                  .map(({ x, low }) => `${String(x)} ${String(low)}`)
                  .join("L")}Z`}
              />
              <path
                className="experiment-line"
                d={`M${means.map(({ x, y }) => `${String(x)} ${String(y)}`).join("L")}`}
              />
            </>
          ) : null}
          <RunDots dots={curve.dots} />
        </g>
        {means.map(({ x, y, low, high, point }, place) => (
          <g
            key={point.number}
            role="button"
            className="experiment-mean"
            data-testid={`point-${String(point.number)}`}
            tabIndex={place === Math.min(at, means.length - 1) ? 0 : -1}
            aria-label={`${pointWords(study, point)}: ${cellWords(point.cells[measure])}`}
            aria-pressed={point.number === chosen}
            onFocus={() => setAt(place)}
          >
            <path
              d={`M${String(x)} ${String(low)}V${String(high)}M${String(x - 5)} ${String(low)}h10M${String(x - 5)} ${String(high)}h10`}
            />
            <circle cx={x} cy={y} r={5} />
          </g>
        ))}
      </svg>
    </div>
  );
}

const RunDots = memo(function RunDots({ dots }: { dots: readonly Dot[] }) {
  const played = useStudy((state) => state.played);
  return dots.map(({ x, y, run }) => (
    <circle key={run.row} className="experiment-dot" data-played={run.row === played} cx={x} cy={y} r={3} />
  ));
});
