/** Numbers, measures and points of a study in words. */
import type { Study, StudyCell, StudyPoint } from "../../api/generated";
import { decimal, grouped } from "../../i18n/numbers";
import { type Key, t } from "../../i18n/words";

const MEASURES: Readonly<Record<string, Key>> = {
  seconds: "experiment.measure-seconds",
  done: "experiment.measure-done",
  delivered: "experiment.measure-delivered",
  collisions: "experiment.measure-collisions",
  distance: "experiment.measure-distance",
  energy: "experiment.measure-energy",
};

export function measureWords(name: string): string {
  const key = MEASURES[name];
  return key === undefined ? name : t(key);
}

/** About four figures of a number. */
export function figure(value: number): string {
  const size = Math.abs(value);
  if (size >= 1000) return grouped(value);
  return decimal(value, 0, size >= 100 ? 1 : size >= 1 ? 2 : 4);
}

export function valueWords(value: number | string): string {
  return typeof value === "number" ? figure(value) : value;
}

/** `carry.v3.speed = 30 · radio.loss = 5`; "" where nothing varies. */
export function pointWords({ axes }: Study, point: StudyPoint): string {
  return axes.map(({ address }, at) => `${address} = ${valueWords(point.values[at] ?? "")}`).join(" · ");
}

/** `83.1 (80.2 … 85.9)`. */
export function cellWords(cell: StudyCell | undefined): string {
  if (cell === undefined || cell.estimate === null) return t("experiment.nothing");
  if (cell.low === null || cell.high === null) return figure(cell.estimate);
  return t("experiment.interval", {
    estimate: figure(cell.estimate),
    low: figure(cell.low),
    high: figure(cell.high),
  });
}
