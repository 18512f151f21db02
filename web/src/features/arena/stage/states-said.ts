/** Announces faults of robots as they happen to screen readers. */
import { useEffect, useRef } from "react";

import { FAILED, MUTED, STALLED } from "../../../api/wire";
import type { Scene } from "../../../components/scene/scene";
import { t } from "../../../i18n/words";
import { posesAt, watchFrames } from "../../../session/poses";
import { announce } from "../robots";
import { states } from "../summary";

/** So many are named at once. */
const MOST_NAMED = 5;

/** What is new since before: name → what befell each. */
export function newStates(before: ReadonlyMap<string, string>, now: ReadonlyMap<string, string>): string[] {
  const words: string[] = [];
  for (const [name, said] of now) if (before.get(name) !== said) words.push(t("arena.now", { name, states: said }));
  for (const name of before.keys()) {
    if (!now.has(name)) words.push(t("arena.now", { name, states: t("arena.well") }));
  }
  return words.slice(0, MOST_NAMED);
}

function statesOf(scene: Scene): Map<string, string> {
  const poses = scene.running ? (posesAt(0, false)?.poses ?? null) : null;
  const found = new Map<string, string>();
  if (poses === null) return found;
  poses.forEach(({ flags }, index) => {
    if ((flags & (FAILED | STALLED | MUTED)) === 0) return;
    const has = (bit: number) => (flags & bit) !== 0;
    const words = states({ failed: has(FAILED), stalled: has(STALLED), muted: has(MUTED) });
    found.set(scene.actors[index]?.name ?? "", words.join(", "));
  });
  return found;
}

/** While something runs: what befalls robots is said as it happens. */
export function useStatesSaid(scene: Scene | null): void {
  const latest = useRef(scene);
  useEffect(() => {
    latest.current = scene;
  });
  useEffect(() => {
    let before = new Map<string, string>();
    return watchFrames(() => {
      if (latest.current === null) return;
      const now = statesOf(latest.current);
      const words = newStates(before, now);
      before = now;
      if (words.length > 0) announce(words.join(". "));
    });
  }, []);
}
