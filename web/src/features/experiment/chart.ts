/** What picture a study has, and where its dots are: sizes in px, y downwards. */
import type { KeyboardEvent } from "react";

import type { Study, StudyPoint, StudyRun } from "../../api/generated";

type FoundValue = number | string;

/**
 * `dots`: one point. `curve`: one axis, in order. `map`: two axes with each combination. `maps`: a map for each value of a
 * third axis. `scatter`: anything else, over its first axis.
 */
export type Picture = "dots" | "curve" | "map" | "maps" | "scatter";

/** The places of the axes that have more than one value. */
export function variedAxes({ axes }: Study): number[] {
  return axes.flatMap(({ values }, at) => (values.length > 1 ? [at] : []));
}

/** The picture of a study. */
export function pictureOf(study: Study): Picture {
  const varied = variedAxes(study);
  const combinations = varied.reduce((count, at) => count * (study.axes[at]?.values.length ?? 1), 1);
  const isGrid = combinations * study.seeds === study.total;
  if (varied.length === 0) return "dots";
  if (!isGrid || varied.length > 3) return "scatter";
  return varied.length === 1 ? "curve" : varied.length === 2 ? "map" : "maps";
}

export interface Scale {
  low: number;
  high: number;
  /** Where a value is, in px. */
  at: (value: number) => number;
}

/** A scale of values onto px; values that are all alike are in the middle. */
export function scaleOf(values: readonly number[], from: number, to: number): Scale {
  const [least, most] = [Math.min(...values), Math.max(...values)];
  const room = most > least ? (most - least) * 0.05 : Math.abs(most) * 0.05 || 1;
  const [low, high] = values.length === 0 ? [0, 1] : [least - room, most + room];
  return { low, high, at: (value) => from + ((value - low) / (high - low)) * (to - from) };
}

/** Round numbers of a scale, about so many. */
export function ticksOf({ low, high }: Pick<Scale, "low" | "high">, count: number): number[] {
  const rough = (high - low) / Math.max(1, count);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = ([1, 2, 5].find((one) => one * power >= rough) ?? 10) * power;
  const first = Math.ceil(low / step);
  const last = Math.floor(high / step + 1e-9);
  // Without the dust of adding steps.
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, at) => Math.round((first + at) * step * 1e9) / 1e9);
}

/** The place of a value on an axis: itself where all are numbers, else its number in their order. */
export function placeOn(values: readonly FoundValue[], value: FoundValue): number {
  return values.every((one) => typeof one === "number") && typeof value === "number" ? value : values.indexOf(value);
}

export interface Dot {
  x: number;
  y: number;
  run: StudyRun;
}

export interface Mean {
  x: number;
  y: number;
  low: number;
  high: number;
  point: StudyPoint;
}

export interface Curve {
  means: Mean[];
  dots: Dot[];
  /** Marks of the axes: where they are, and what they say. */
  xs: { at: number; value: FoundValue }[];
  ys: { at: number; value: number }[];
}

export interface Frame {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/** A measure over an axis: means with their intervals, and the runs that are known. */
export function curveOf(
  study: Study,
  { axis, measure, runs, frame }: { axis: number; measure: number; runs: readonly StudyRun[]; frame: Frame },
): Curve {
  const values = study.axes[axis]?.values ?? [];
  const xOf = (point: StudyPoint) => placeOn(values, point.values[axis] ?? 0);
  const cells = study.points.flatMap((point) => {
    const cell = point.cells[measure];
    return cell === undefined || cell.estimate === null ? [] : [{ point, cell, estimate: cell.estimate }];
  });
  const found = runs.flatMap((run) => {
    const value = run.measures[measure];
    return value == null ? [] : [{ run, value }];
  });
  const reach = cells.flatMap(({ cell, estimate }) => [cell.low ?? estimate, cell.high ?? estimate]);
  const x = scaleOf(
    values.map((one) => placeOn(values, one)),
    frame.left,
    frame.right,
  );
  const y = scaleOf([...reach, ...found.map(({ value }) => value)], frame.bottom, frame.top);
  const places = new Map(study.points.map((point) => [point.number, x.at(xOf(point))]));
  const isNumeric = values.every((one) => typeof one === "number");
  return {
    means: cells.map(({ point, cell, estimate }) => ({
      x: x.at(xOf(point)),
      y: y.at(estimate),
      low: y.at(cell.low ?? estimate),
      high: y.at(cell.high ?? estimate),
      point,
    })),
    dots: found.flatMap(({ run, value }) => {
      const at = places.get(Math.floor(run.row / study.seeds));
      return at === undefined ? [] : [{ x: at, y: y.at(value), run }];
    }),
    xs:
      isNumeric && values.length > 8
        ? ticksOf(x, 6).map((value) => ({ at: x.at(value), value }))
        : values.map((value) => ({ at: x.at(placeOn(values, value)), value })),
    ys: ticksOf(y, 4).map((value) => ({ at: y.at(value), value })),
  };
}

/** Dots of runs over one scale, by their numbers; those that would cover each other stand on each other. */
export function stackRuns(
  runs: readonly StudyRun[],
  measure: number,
  { width, size, edge }: { width: number; size: number; edge: number },
): { dots: Dot[]; scale: Scale; height: number } {
  const found = runs
    .flatMap((run) => {
      const value = run.measures[measure];
      return value == null ? [] : [{ run, value }];
    })
    .sort((a, b) => a.value - b.value || a.run.row - b.run.row);
  const scale = scaleOf(
    found.map(({ value }) => value),
    edge,
    width - edge,
  );
  const columns = new Map<number, number>();
  const dots = found.map(({ run, value }) => {
    const column = Math.round(scale.at(value) / size);
    const below = columns.get(column) ?? 0;
    columns.set(column, below + 1);
    return { x: column * size, y: below, run };
  });
  const most = Math.max(1, ...columns.values());
  // Many dots come closer, so that the pile stays in its place.
  const step = Math.min(size, 96 / most);
  const height = Math.max(size, step * (most - 1) + size);
  return { dots: dots.map((dot) => ({ ...dot, y: height - size / 2 - dot.y * step })), scale, height };
}

/** The dot that is nearest to a place, of those that are no further than that. */
export function nearest<One extends { x: number; y: number }>(
  dots: readonly One[],
  x: number,
  y: number,
  reach: number,
): One | null {
  let best: One | null = null;
  let least = reach;
  for (const dot of dots) {
    const away = Math.hypot(dot.x - x, dot.y - y);
    if (away <= least) [best, least] = [dot, away];
  }
  return best;
}

/** A key on the dots of a picture: arrows, Home and End lead to another than the one `at`, Enter and Space take that. */
export function walkDots(event: KeyboardEvent, picture: SVGElement | null, at: number, take: () => void): void {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const dots = picture?.querySelectorAll<SVGElement>("[role=button]") ?? [];
  const last = dots.length - 1;
  const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: last }[event.key];
  if (to === undefined && event.key !== "Enter" && event.key !== " ") return;
  event.preventDefault();
  event.stopPropagation();
  if (to === undefined) take();
  else dots[Math.min(Math.max(to, 0), last)]?.focus();
}

/** The share (0…1) of a measure's span that a point is at; null where it has no number. */
export function shareOf(study: Study, measure: number): (point: StudyPoint | undefined) => number | null {
  const all = study.points.flatMap((point) => point.cells[measure]?.estimate ?? []);
  const [least, most] = [Math.min(...all), Math.max(...all)];
  return (point) => {
    const estimate = point?.cells[measure]?.estimate ?? null;
    return estimate === null ? null : most > least ? (estimate - least) / (most - least) : 0;
  };
}
