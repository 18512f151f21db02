import { describe, expect, it } from "vitest";

import held from "../testing/worlds.json";
import type { OwnWorld } from "../types";
import { startPlace } from "./drawing";
import { startNear } from "./free-start";

const WORLDS = (held as unknown as { own: OwnWorld }[]).map(({ own }) => own);

/** How near the nearest two starts are, in mm. */
function nearest(world: OwnWorld): number {
  const places = world.starts.flatMap((start) => startPlace(world, start) ?? []);
  let least = Infinity;
  places.forEach((one, at) => {
    for (const other of places.slice(at + 1)) least = Math.min(least, Math.hypot(one.x - other.x, one.y - other.y));
  });
  return least;
}

describe("a start for one more robot", () => {
  it("is beside another, away from all, on a road where that one is on a road, in every world", () => {
    for (const world of WORLDS) {
      const before = nearest(world);
      const beside = world.starts[0]?.name ?? "";
      const made = startNear(world, beside, "one-more");
      if (made === null) continue;
      const after = { ...world, starts: [...world.starts, made] };
      expect(nearest(after), world.name).toBeGreaterThanOrEqual(Math.min(before, 120));
      expect(startPlace(after, made), world.name).not.toBeNull();
    }
    expect(WORLDS.filter((world) => startNear(world, "", "one-more") === null)).toEqual([]);
  });

  it("follows on the road, one after another", () => {
    const ring = WORLDS.find(({ name }) => name === "ring") as OwnWorld;
    let world = ring;
    const beside = ring.starts.find(({ at }) => at === "road")?.name ?? "";
    for (let number = 1; number <= 4; number++) {
      const made = startNear(world, beside, `more-${String(number)}`);
      expect(made?.at).toBe("road");
      if (made !== null) world = { ...world, starts: [...world.starts, made] };
    }
    expect(nearest(world)).toBeGreaterThanOrEqual(Math.min(nearest(ring), 120));
  });

  it("is none where the world is full", () => {
    const [any] = WORLDS;
    expect(startNear({ ...(any as OwnWorld), starts: [], width_mm: 100, height_mm: 100 }, "", "x")).toBeNull();
  });
});
