/** Sentences that say what a hand does: where fingers point it taps, and there are no keys. */
import type { Key } from "./words";

const TOUCH = {
  "inspector.nothing-help": "inspector.nothing-tap",
  "fields.where": "fields.where-tap",
  "graph.first-help": "graph.first-tap",
  "graph.or-press": "graph.or-tap",
  "sweep.how": "sweep.how-tap",
  "world.draw": "world.draw-tap",
  "world.hint": "world.hint-tap",
} as const satisfies Partial<Record<Key, Key>>;

/** Whether fingers point, and no mouse does. */
export function pointsByTouch(): boolean {
  return typeof matchMedia === "function" && matchMedia("(pointer: coarse)").matches;
}

/** The key of the sentence for the hand that points. */
export function handKey(key: keyof typeof TOUCH): Key {
  return pointsByTouch() ? TOUCH[key] : key;
}
