/**
 * What a thing of a mission's own world is: a kind and its number from 0, as the server's problems name it.
 *
 * What is done to things is in the files beside it, which are fetched with the editor.
 */
import type { OwnWorld } from "../types";

/** Places that are dragged go by this. */
export const GRID_MM = 10;

export const KINDS = ["wall", "floor", "line", "road", "storehouse", "dock", "start", "box", "ball", "zone"] as const;
export type Kind = (typeof KINDS)[number];

export interface PartReference {
  kind: Kind;
  at: number;
}

export const FIELD = {
  wall: "walls",
  floor: "floors",
  line: "lines",
  road: "roads",
  storehouse: "storehouses",
  dock: "docks",
  start: "starts",
  box: "boxes",
  ball: "balls",
  zone: "zones",
} as const;

export type Part<K extends Kind> = NonNullable<OwnWorld[(typeof FIELD)[K]]>[number];
export type AnyPart = Part<Kind>;

export const LARGEST_MM = 1_000_000;

/** As files say it: a thousandth of a mm. */
export function tidy(value: number): number {
  const held = Math.min(Math.max(value, -LARGEST_MM), LARGEST_MM);
  return Math.round(held * 1000) / 1000 + 0;
}

export function partsOfKind<K extends Kind>(world: OwnWorld, kind: K): readonly Part<K>[] {
  // A server from before there were such things sends none.
  return world[FIELD[kind]] ?? [];
}

export function partOf<K extends Kind>(world: OwnWorld, thing: { kind: K; at: number }): Part<K> | undefined {
  return partsOfKind(world, thing.kind)[thing.at];
}

export function isSamePart(one: PartReference, other: PartReference): boolean {
  return one.kind === other.kind && one.at === other.at;
}

export function partReferences(world: OwnWorld): PartReference[] {
  return KINDS.flatMap((kind) => partsOfKind(world, kind).map((_, at) => ({ kind, at })));
}

/** The thing that a problem is about, "road:0"; null when it is about none of this world. */
export function thingNamed(world: OwnWorld | null | undefined, words: string | undefined): PartReference | null {
  if (world == null) return null;
  const [kind = "", number = ""] = (words ?? "").split(":");
  const found = KINDS.find((one) => one === kind);
  const at = Number(number);
  return found !== undefined && partsOfKind(world, found)[at] !== undefined ? { kind: found, at } : null;
}
