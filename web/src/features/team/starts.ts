/** Who has no start in the world, and names for new robots. */
import { startOf } from "../../model/starts";
import type { Mission, World } from "../../model/types";

/** The agents whose start the world has not, by their place in the list. */
export function withoutStart(mission: Mission, world: World | null): number[] {
  if (world === null) return [];
  const known = new Set(world.starts.map((start) => start.name));
  return mission.agents.flatMap((agent, at) => (known.has(startOf(agent)) ? [] : [at]));
}

/** A free name like the given one: `carrier-1` gives `carrier-2`. */
export function nameLike(name: string, taken: readonly string[]): string {
  const stem = name.replace(/[-\s]?\d+$/, "");
  for (let number = 1; ; number++) {
    const next = `${stem === "" ? "robot" : stem}-${String(number)}`;
    if (!taken.includes(next)) return next;
  }
}
