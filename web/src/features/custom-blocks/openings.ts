/** What is left open in a part that is made from a selection: the server's offers, and what the person chose of them. */
import { readWhole } from "../../i18n/numbers";
import type { ChosenSlot, Offer } from "../../api/generated";

export interface Opening {
  offer: Offer;
  key: string;
  on: boolean;
  name: string;
  min: string;
  max: string;
  first: string;
  unit: string;
}

export const TYPED: readonly Offer["kind"][] = ["number", "value", "text"];

export function keyOf({ vertex, slot }: { vertex: string; slot: string }): string {
  return `${vertex} ${slot}`;
}

/** The offers as they are shown at first: only what has to be open is. */
export function openingsOf(offers: readonly Offer[]): Opening[] {
  return offers.map((offer) => ({
    offer,
    key: keyOf(offer),
    on: offer.is_open,
    name: offer.name,
    min: String(offer.min),
    max: String(offer.max),
    first: offer.value,
    unit: offer.unit,
  }));
}

/** How deep each offer lies inside others, or -1 while one of those is open: then it goes along. */
export function depthsOf(all: readonly Opening[]): number[] {
  const byKey = new Map(all.map((one) => [one.key, one]));
  return all.map((one) => depthOf(one, byKey));
}

function depthOf(opening: Opening, byKey: ReadonlyMap<string, Opening>): number {
  let depth = 0;
  for (let { inside } = opening.offer; inside !== null; depth++) {
    const around = byKey.get(keyOf(inside));
    if (around === undefined) break;
    if (around.on) return -1;
    inside = around.offer.inside;
  }
  return depth;
}

/** A number of a range, which begins at 0 at the least. */
export function whole(text: string): number | null {
  const number = readWhole(text);
  return number !== null && number >= 0 ? number : null;
}

/** The value at first: a number in the digits of a program. */
export function defaultOf(kind: string, first: string): string {
  const number = kind === "text" ? null : readWhole(first);
  return number === null ? first.trim() : String(number);
}

/** What is sent to the server. */
export function chosenOf(openings: readonly Opening[]): ChosenSlot[] {
  const depths = depthsOf(openings);
  return openings
    .filter((one, at) => one.on && (depths[at] ?? 0) >= 0)
    .map(({ offer: { vertex, slot, kind }, name, min, max, first, unit }) =>
      TYPED.includes(kind)
        ? {
            vertex,
            slot,
            name,
            min: whole(min),
            max: whole(max),
            default: defaultOf(kind, first) || null,
            unit: unit.trim(),
          }
        : { vertex, slot, name },
    );
}
