/** Sentences that say what a hand does: where fingers point it taps, and there are no keys. */
import type { Key } from "./words";

const TOUCH = {
  "inspector.nothing-help": "inspector.nothing-tap",
  "fields.where": "fields.where-tap",
  "graph.first-help": "graph.first-tap",
  "sweep.how": "sweep.how-tap",
  "experiment.how": "experiment.how-tap",
  "world.draw": "world.draw-tap",
  "world.hint": "world.hint-tap",
} as const satisfies Partial<Record<Key, Key>>;

/** Whether fingers point at the page, and no mouse does. */
export function hasCoarsePointer(): boolean {
  return matchMedia("(pointer: coarse)").matches;
}

/** The key of the sentence for the hand that points. */
export function handKey(key: keyof typeof TOUCH): Key {
  return hasCoarsePointer() ? TOUCH[key] : key;
}
