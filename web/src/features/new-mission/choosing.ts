/** What is chosen for a new mission, and what fits it: a kit of robots, a place for it, a first program for both. */
import type { Beginnings, Kit, BeginningPlace, Starter } from "../../api/generated";

/** The starter without parts; it fits everything. */
export const NOTHING = "nothing";

export interface Choice {
  kit: string;
  place: string;
  starter: string;
}

function kitOf({ kits }: Beginnings, name: string): Kit | undefined {
  return kits.find((kit) => kit.name === name);
}

export function placeFits(all: Beginnings, kit: string, place: string): boolean {
  return kitOf(all, kit)?.places.includes(place) === true;
}

export function starterFits({ places }: Starter, { kit, place }: Choice): boolean {
  return places[kit]?.includes(place) === true;
}

/**
 * The nearest choice that can be had: the kit stays, a place that it does not fit gives way to its first one, and a starter
 * to the first that moves there, or to none.
 */
export function settled(all: Beginnings, wish: Choice): Choice {
  const kit = kitOf(all, wish.kit) ?? all.kits[0];
  if (kit === undefined) return wish;
  const place = kit.places.includes(wish.place) ? wish.place : (kit.places[0] ?? "");
  const choice = { kit: kit.name, place, starter: wish.starter };
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
