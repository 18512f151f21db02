/**
 * What variables and sensors said over time, for the plots: the last `MOST` moments of the run that is on.
 *
 * A sample is taken of each message of a run; going back takes nothing away, another future does.
 */
import { useRun } from "../../session/run";

const MOST = 2000;

export interface Sample {
  tick: number;
  /** agent → name → value. */
  values: ReadonlyMap<string, Readonly<Record<string, number>>>;
}

let samples: Sample[] = [];

export function samplesNow(): readonly Sample[] {
  return samples;
}

/** One value over time, oldest first. */
export function seriesOf(taken: readonly Sample[], agent: string, name: string): [tick: number, value: number][] {
  return taken.flatMap(({ tick, values }): [number, number][] => {
    const value = values.get(agent)?.[name];
    return value === undefined ? [] : [[tick, value]];
  });
}

/** A value as steps: `d` of a path in a box of that size, over the ticks `from`…`to`. */
export function stepsPath(
  series: readonly [tick: number, value: number][],
  box: { width: number; height: number },
  span: { from: number; to: number; least: number; most: number },
): string {
  const x = (tick: number) => ((tick - span.from) / Math.max(1, span.to - span.from)) * box.width;
  const y = (value: number) =>
    box.height - ((value - span.least) / Math.max(1e-9, span.most - span.least)) * box.height;
  const [first, ...rest] = series;
  if (first === undefined) return "";
  const start = `M${x(first[0]).toFixed(1)} ${y(first[1]).toFixed(1)}`;
  return `${start}${rest.map(([tick, value]) => `H${x(tick).toFixed(1)}V${y(value).toFixed(1)}`).join("")}H${x(span.to).toFixed(1)}`;
}

/** Takes samples as the run goes; the returned function ends that. */
export function takeSamples(): () => void {
  return useRun.subscribe((now, before) => {
    if (now.latest === 0) samples = [];
    if (now.agents.length === 0) return;
    if (now.agents === before.agents && now.tick === before.tick) return;
    if (now.latest < before.latest) samples = samples.filter((one) => one.tick < now.tick);
    const last = samples.at(-1);
    if (last !== undefined && now.tick <= last.tick) return;
    const values = new Map(now.agents.map((agent) => [agent.name, { ...agent.inputs, ...agent.values }]));
    samples = [...samples.slice(1 - MOST), { tick: now.tick, values }];
  });
}
