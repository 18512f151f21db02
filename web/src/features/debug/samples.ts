/**
 * What variables and sensors said over time, for the plots: the last `MOST` moments of the run that is on.
 *
 * A sample is taken of each message of a run; going back takes nothing away, another future does.
 */
import { create } from "zustand";

import { useRun } from "../../session/run";

const MOST = 2000;

export interface Sample {
  tick: number;
  /** agent → name → value. */
  values: ReadonlyMap<string, Readonly<Record<string, number>>>;
}

interface Bounds {
  least: number;
  most: number;
}

const useSamples = create<{ samples: readonly Sample[] }>(() => ({ samples: [] }));

export function samplesNow(): readonly Sample[] {
  return useSamples.getState().samples;
}

/** One value over time, oldest first. */
export function seriesOf(taken: readonly Sample[], agent: string, name: string): [tick: number, value: number][] {
  const series: [tick: number, value: number][] = [];
  for (const { tick, values } of taken) {
    const value = values.get(agent)?.[name];
    if (value !== undefined) series.push([tick, value]);
  }
  return series;
}

/** The least and the most that a series and the present value reach. */
export function boundsOf(series: readonly [tick: number, value: number][], now: number): Bounds {
  let [least, most] = [now, now];
  for (const [, value] of series) {
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  return { least, most };
}

/** How far below the top of a box a value lies; where all are the same, in the middle. */
export function levelOf(value: number, { height }: { height: number }, { least, most }: Bounds): number {
  return least === most ? height / 2 : ((most - value) / (most - least)) * height;
}

/**
 * A value as steps: `d` of a path in a box of that size, over the ticks `from`…`to`.
 *
 * Only what changes is drawn, and of one column of the box only what is seen: how far it reaches and where it ends. A
 * path is as long as the box is wide, however many moments there are.
 */
export function stepsPath(
  series: readonly [tick: number, value: number][],
  box: { width: number; height: number },
  span: Bounds & { from: number; to: number },
): string {
  const column = (tick: number) => Math.round(((tick - span.from) / Math.max(1, span.to - span.from)) * box.width * 2);
  const y = (value: number) => levelOf(value, box, span).toFixed(1);
  const [first] = series;
  if (first === undefined) return "";
  let at = column(first[0]);
  let path = `M${String(at / 2)} ${y(first[1])}`;
  let [drawn, last, least, most] = [first[1], first[1], first[1], first[1]];
  for (const [tick, value] of series) {
    if (value === last) continue;
    const now = column(tick);
    if (now !== at) {
      path += `${last === drawn ? "" : `V${y(last)}`}H${String(now / 2)}`;
      [at, drawn, least, most] = [now, last, last, last];
    }
    last = value;
    if (value >= least && value <= most) continue;
    path += `V${y(value)}`;
    [drawn, least, most] = [value, Math.min(least, value), Math.max(most, value)];
  }
  return `${path}${last === drawn ? "" : `V${y(last)}`}H${String(column(span.to) / 2)}`;
}

/** Takes samples as the run goes; the returned function ends that. */
export function takeSamples(): () => void {
  return useRun.subscribe((now, before) => {
    if (now.latest === 0) useSamples.setState({ samples: [] });
    if (now.agents.length === 0) return;
    if (now.agents === before.agents && now.tick === before.tick) return;
    const kept = samplesNow();
    const samples = now.latest < before.latest ? kept.filter((one) => one.tick < now.tick) : kept;
    const last = samples.at(-1);
    if (last !== undefined && now.tick <= last.tick) return;
    const values = new Map(now.agents.map((agent) => [agent.name, { ...agent.inputs, ...agent.values }]));
    useSamples.setState({ samples: [...samples.slice(1 - MOST), { tick: now.tick, values }] });
  });
}
