/** Which cards are shown, in which order, and what a card says of its pupil: pure functions. */
import type { Pupil } from "../../../api/generated";
import { t } from "../../../i18n/words";
import { holding } from "../../../ui/matching";

export type Filter = "all" | "help" | "work" | "done" | "away";
export type Order = "help" | "name" | "goals";

export const FILTERS: readonly Filter[] = ["all", "help", "work", "done", "away"];
export const ORDERS: readonly Order[] = ["help", "name", "goals"];

/** A pupil, and the moment (ms) at which `seconds` was true. */
export interface Seen {
  pupil: Pupil;
  at: number;
}

export function met({ goals }: Pupil): number {
  return goals.filter(({ reached }) => reached === true).length;
}

const FILTER_OF: Record<Pupil["state"], Filter> = {
  asks: "help",
  stuck: "help",
  running: "work",
  editing: "work",
  done: "done",
  away: "away",
};

/** Under which filter a pupil is; one who met all goals and runs again is done. */
export function filterOf(pupil: Pupil, goals: number): Filter {
  if (pupil.state === "running" && goals > 0 && met(pupil) === goals) return "done";
  return FILTER_OF[pupil.state];
}

export function counts(pupils: readonly Pupil[], goals: number): Record<Filter, number> {
  const found: Record<Filter, number> = { all: pupils.length, help: 0, work: 0, done: 0, away: 0 };
  for (const pupil of pupils) found[filterOf(pupil, goals)]++;
  return found;
}

export function shown(pupils: readonly Pupil[], filter: Filter, find: string, goals: number): Pupil[] {
  const wanted = holding(find);
  return pupils.filter((pupil) => (filter === "all" || filterOf(pupil, goals) === filter) && wanted(pupil.name));
}

const URGENT: Record<Pupil["state"], number> = { stuck: 0, asks: 1, running: 3, editing: 2, done: 4, away: 5 };

/** The folders in order: who needs help longest, then who has fewest goals; by name where all is equal. */
export function sorted(pupils: readonly Pupil[], order: Order): string[] {
  const byName = (one: Pupil, other: Pupil) => one.name.localeCompare(other.name);
  const help = ({ state }: Pupil) =>
    state === "stuck" || state === "asks" ? 0 : state === "done" ? 2 : state === "away" ? 3 : 1;
  const wait = ({ state, seconds }: Pupil) => (state === "stuck" || state === "asks" ? (seconds ?? 0) : 0);
  const compare: Record<Order, (one: Pupil, other: Pupil) => number> = {
    name: byName,
    goals: (one, other) => met(one) - met(other) || byName(one, other),
    help: (one, other) =>
      help(one) - help(other) ||
      wait(other) - wait(one) ||
      met(one) - met(other) ||
      URGENT[one.state] - URGENT[other.state] ||
      byName(one, other),
  };
  return [...pupils].sort(compare[order]).map(({ folder }) => folder);
}

/** How long the state lasts by now, in whole minutes. */
export function minutes({ pupil: { seconds }, at }: Seen, now: number): number | null {
  return seconds === null ? null : Math.floor((seconds + Math.max(0, now - at) / 1000) / 60);
}

/** Icon, words, and whether it wants the teacher's eye. */
export function stateWords(seen: Seen, goals: number, now: number): { icon: string; words: string; calls: boolean } {
  const { pupil } = seen;
  const count = minutes(seen, now);
  switch (pupil.state) {
    case "asks":
      return { icon: "hand", words: t("teacher.state-asks"), calls: true };
    case "stuck":
      return { icon: "pause", words: t("teacher.state-stuck", { count: count ?? 0 }), calls: true };
    case "running":
      return goals > 0 && met(pupil) === goals
        ? { icon: "circle-dot", words: t("teacher.state-again"), calls: false }
        : { icon: "circle-dot", words: t("teacher.state-running"), calls: false };
    case "editing":
      return { icon: "pencil", words: t("teacher.state-editing"), calls: false };
    case "done":
      return { icon: "circle-check", words: t("teacher.state-done"), calls: false };
    case "away":
      if (count === null) return { icon: "circle-dashed", words: t("teacher.state-never"), calls: false };
      return {
        icon: "circle-dashed",
        words: count === 0 ? t("teacher.state-away-now") : t("teacher.state-away", { count }),
        calls: false,
      };
  }
}

/** Where a key leads among `count` cards in rows of `columns`, from the card `at`; null for other keys. */
export function walkCards(key: string, at: number, count: number, columns: number, mirrored: boolean): number | null {
  const forward = mirrored ? "ArrowLeft" : "ArrowRight";
  const back = mirrored ? "ArrowRight" : "ArrowLeft";
  const steps: Record<string, number> = {
    [forward]: at + 1,
    [back]: at - 1,
    ArrowDown: at + columns < count ? at + columns : at,
    ArrowUp: at - columns >= 0 ? at - columns : at,
    Home: 0,
    End: count - 1,
  };
  const to = steps[key];
  return to === undefined || count === 0 ? null : Math.min(Math.max(to, 0), count - 1);
}
