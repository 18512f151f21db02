/** One value over time as a line, scaled to what was seen, with its least, its most and its present value beside it. */
import { useMemo } from "react";

import { t } from "../../i18n/words";
import type { RobotObject } from "../../model/types";
import { valueWords } from "../../model/words";
import { useRun } from "../../session/run";
import { boundsOf, levelOf, samplesNow, seriesOf, stepsPath } from "./samples";

/** So wide that variables and sensors stand side by side above a graph of the usual width. */
const PLOT = { width: 72, height: 32 };
/** Room around the line for its own width and for the dot. */
const EDGE = 4;

interface Props {
  agent: string;
  object: RobotObject;
  label: string;
  value: number;
}

export function Plot({ agent, object, label, value }: Props) {
  const tick = useRun((run) => run.tick);
  const latest = useRun((run) => run.latest);
  const { least, most, line, now } = useMemo(() => {
    const series = seriesOf(samplesNow(), agent, object.name);
    const from = series[0]?.[0] ?? 0;
    const bounds = boundsOf(series, value);
    const span = { from, to: Math.max(latest, tick, from + 1), ...bounds };
    const x = ((tick - from) / (span.to - from)) * PLOT.width;
    return { ...bounds, line: stepsPath(series, PLOT, span), now: { x, y: levelOf(value, PLOT, span) } };
  }, [agent, object, tick, latest, value]);
  const words = (one: number) => valueWords(object, one);
  const flat = least === most;
  const said = { name: label, least: words(least), most: words(most), now: words(value) };
  return (
    <div className="watch-plot flex gap-s" role="img" aria-label={t("debug.plot-of", said)}>
      <svg width={PLOT.width + 2 * EDGE} height={PLOT.height + 2 * EDGE} aria-hidden>
        <g transform={`translate(${String(EDGE)} ${String(EDGE)})`}>
          <path className="watch-now" d={`M${now.x.toFixed(1)} 0V${String(PLOT.height)}`} />
          <path className="watch-line unscaled" d={line} />
          <circle className="watch-dot" cx={now.x} cy={now.y} r={3} />
        </g>
      </svg>
      {/* As on an axis: the most above, the least below; what is there now is set apart, and said once. */}
      <span className="watch-figures muted nowrap tiny-text figures">
        <span data-now={value === most}>{flat ? null : said.most}</span>
        <span data-now>{flat || (value !== least && value !== most) ? said.now : null}</span>
        <span data-now={value === least}>{flat ? null : said.least}</span>
      </span>
    </div>
  );
}
