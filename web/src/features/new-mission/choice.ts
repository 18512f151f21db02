/** What is chosen for a new mission, and what fits it: a robotSet of robots, a place for it, a first program for both. */
import type { Beginnings, RobotSet, BeginningPlace, Starter } from "../../api/generated";

/** The starter without parts; it fits everything. */
export const NOTHING = "nothing";

export interface Choice {
  robotSet: string;
  place: string;
  starter: string;
}

function setOf({ robot_sets }: Beginnings, name: string): RobotSet | undefined {
  return robot_sets.find((robotSet) => robotSet.name === name);
}

export function placeFits(all: Beginnings, robotSet: string, place: string): boolean {
  return setOf(all, robotSet)?.places.includes(place) === true;
}

export function starterFits({ places }: Starter, { robotSet, place }: Choice): boolean {
  return places[robotSet]?.includes(place) === true;
}

/**
 * The nearest choice that can be had: the robotSet stays, a place that it does not fit gives way to its first one, and a starter
 * to the first that moves there, or to none.
 */
export function settled(all: Beginnings, wish: Choice): Choice {
  const robotSet = setOf(all, wish.robotSet) ?? all.robot_sets[0];
  if (robotSet === undefined) return wish;
  const place = robotSet.places.includes(wish.place) ? wish.place : (robotSet.places[0] ?? "");
  const choice = { robotSet: robotSet.name, place, starter: wish.starter };
  const fitting = all.starters.filter((starter) => starterFits(starter, choice));
  const keeps = wish.starter === NOTHING || fitting.some(({ name }) => name === wish.starter);
  return { ...choice, starter: keeps ? wish.starter : (fitting[0]?.name ?? NOTHING) };
}

/** Those that fit first, in their order; the others behind them. */
export function fittingFirst<T>(all: readonly T[], fits: (one: T) => boolean): T[] {
  return [...all.filter(fits), ...all.filter((one) => !fits(one))];
}

export function chosenPlace({ places }: Beginnings, { place }: Choice): BeginningPlace | undefined {
  return places.find(({ name }) => name === place);
}
