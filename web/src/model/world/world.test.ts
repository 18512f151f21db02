import { beforeEach, describe, expect, it } from "vitest";

import { bringWorld, changeOwnWorld, isFreeName, removeThings, renameThing } from "../commands/changeOwnWorld";
import { changeWorld } from "../commands/changeWorld";
import { useStudio } from "../studio";
import { fileOf, missionOf, CARRIER } from "../testing/missions";
import held from "../testing/worlds.json";
import type { Mission, OwnWorld, World } from "../types";
import { drawnWorld, lineOf } from "./drawing";
import { endsOf, snapped, thingAt } from "./hit-test";
import { dragged, gripsOf } from "./grips";
import { lineThrough, nearestOn, placeAt } from "./line";
import { drawNew } from "./part-creation";
import { anchorOf, moved, startMoved } from "./part-movement";
import { withCut, withPoints, withSections } from "./roads";
import { KINDS, thingNamed, partReferences, tidy } from "./part-reference";
import { added, removed, withDependents } from "./part-edits";

const WORLDS = held as unknown as { own: OwnWorld; drawn: World }[];
const ring = WORLDS.find(({ own }) => own.name === "ring")?.own as OwnWorld;

const EMPTY: OwnWorld = {
  name: "w",
  width_mm: 1000,
  height_mm: 800,
  walls: [],
  floors: [],
  lines: [],
  roads: [],
  storehouses: [],
  docks: [],
  starts: [],
  unknown: [],
  label: {},
  help: {},
};

function close(one: unknown, other: unknown, path = ""): void {
  if (typeof one === "number" && typeof other === "number") {
    expect(Math.abs(one - other), path).toBeLessThan(2e-3);
  } else if (typeof other === "object" && other !== null) {
    const [a, b] = [one as Record<string, unknown>, other as Record<string, unknown>];
    if (Array.isArray(other)) expect((one as unknown[]).length, path).toBe(other.length);
    for (const key of Object.keys(b)) close(a[key], b[key], `${path}.${key}`);
  } else {
    expect(one, path).toEqual(other);
  }
}

describe("a world that is changed", () => {
  it.each(WORLDS.map(({ own }) => own.name))("is drawn as the server draws it: %s", (name) => {
    const found = WORLDS.find(({ own }) => own.name === name);
    close(drawnWorld(found?.own as OwnWorld), found?.drawn);
  });

  it("is drawn with straight corners where a radius has no room", () => {
    const points = [
      { x: 0, y: 0, radius: 0 },
      { x: 100, y: 0, radius: 900 },
      { x: 100, y: 100, radius: 0 },
    ];
    expect(lineThrough(points, false)).toBeNull();
    expect(lineOf(points, false)?.points).toEqual([
      [0, 0],
      [100, 0],
      [100, 100],
    ]);
    expect(lineOf([{ x: 1, y: 1, radius: 0 }], false)).toBeNull();
  });

  it("finds its way along a line and back", () => {
    const line = lineOf(ring.roads[0]?.points ?? [], true);
    if (line === null) throw new Error("a ring is a line");
    for (let at = 0; at < line.length; at += 37) {
      const place = placeAt(line, at);
      const found = nearestOn(line, place.x, place.y);
      expect(found.off).toBeLessThan(1e-6);
      expect(Math.abs(found.at - at)).toBeLessThan(0.2);
    }
  });
});

describe("things", () => {
  it("are found where they are drawn, what is on top first", () => {
    expect(thingAt(ring, 350, 380, 5)).toEqual({ kind: "dock", at: 0 });
    expect(thingAt(ring, 60, 300, 5)).toEqual({ kind: "storehouse", at: 0 });
    expect(thingAt(ring, 600, 700, 5)).toEqual({ kind: "road", at: 0 });
    expect(thingAt(ring, 600, 400, 5)).toBeNull();
  });

  it("go where they are moved, and docks along their road", () => {
    for (const thing of partReferences(ring)) {
      const after = moved(moved(ring, thing, 20, 0), thing, -20, 0);
      const [was, is] = [anchorOf(ring, thing), anchorOf(after, thing)];
      expect(Math.hypot((was?.x ?? 0) - (is?.x ?? 0), (was?.y ?? 0) - (is?.y ?? 0))).toBeLessThan(45);
    }
    expect(moved(ring, { kind: "dock", at: 0 }, 100, 60).docks[0]?.at_mm).toBe(100);
    expect(moved(ring, { kind: "storehouse", at: 0 }, 5, -7).storehouses[0]).toMatchObject({ x_mm: 35, y_mm: 233 });
  });

  it("are changed by their grips", () => {
    const { world, thing } = added(EMPTY, "wall", { x1: 0, y1: 0, x2: 10, y2: 0 });
    expect(gripsOf(world, thing).map(({ id }) => id)).toEqual(["end:0", "end:1"]);
    expect(dragged(world, thing, "end:1", 400, 300).walls).toEqual([{ x1: 0, y1: 0, x2: 400, y2: 300 }]);
    expect(dragged(ring, { kind: "storehouse", at: 0 }, "size", 0, 0).storehouses[0]).toMatchObject({
      width_mm: 10,
      height_mm: 10,
    });
    const start = drawNew(EMPTY, "start", { x: 100, y: 100 }, null);
    expect(start?.world.starts[0]).toMatchObject({ at: "pose", x_mm: 100, y_mm: 100 });
    expect(dragged(start?.world ?? EMPTY, { kind: "start", at: 0 }, "heading", 100, 200).starts[0]?.heading_deg).toBe(
      90,
    );
  });

  it("take along what cannot be without them", () => {
    const gone = withDependents(ring, [{ kind: "storehouse", at: 0 }]);
    expect(gone).toEqual([
      { kind: "storehouse", at: 0 },
      { kind: "dock", at: 0 },
      { kind: "start", at: 3 },
      { kind: "start", at: 5 },
    ]);
    expect(removed(ring, gone).starts.map(({ name }) => name)).toEqual([
      "carrier-1",
      "carrier-2",
      "carrier-3",
      "unloader",
      "store-manager-B",
    ]);
  });

  it("are named by the server's problems", () => {
    expect(thingNamed(ring, "road:0")).toEqual({ kind: "road", at: 0 });
    for (const wrong of ["road:9", "world:0", "", undefined, "cow:1", "road:-1", "road:x"]) {
      expect(thingNamed(ring, wrong)).toBeNull();
    }
    expect(thingNamed(null, "road:0")).toBeNull();
  });

  it("of every kind are drawn with one press, but no dock without a road", () => {
    let world = EMPTY;
    for (const kind of KINDS) {
      const made = drawNew(world, kind, { x: 500, y: 400 }, null);
      expect(made?.thing).toEqual({ kind, at: 0 });
      world = made?.world ?? world;
    }
    expect(drawNew(EMPTY, "dock", { x: 1, y: 1 }, null)).toBeNull();
  });
});

describe("sections", () => {
  const road = ring.roads[0];

  it("are cut elsewhere, between their neighbours", () => {
    const after = withCut(ring, 0, 1, 200).roads[0]?.sections ?? [];
    expect([after[0]?.to_mm, after[1]?.from_mm]).toEqual([200, 200]);
    expect(withCut(ring, 0, 1, 99_999).roads[0]?.sections[0]?.to_mm).toBe(496.389);
    expect(withCut(ring, 0, 1, -5).roads[0]?.sections[0]?.to_mm).toBe(1);
  });

  it("are as many as are wanted, without gap or overlap, with signs of their own", () => {
    for (const count of [0, 1, 3, 6, 9, 20]) {
      const { sections } = withSections(ring, 0, count).roads[0] ?? { sections: [] };
      expect(sections.length).toBe(count);
      sections.forEach((section, at) => expect(section.to_mm).toBe(sections[at + 1]?.from_mm ?? null));
      expect(new Set(sections.map(({ sign }) => sign)).size).toBe(count);
    }
  });

  it("still fit a road that became shorter", () => {
    const points = (road?.points ?? []).map((point) => ({
      x: tidy(point.x / 2),
      y: tidy(point.y / 2),
      radius: point.radius / 2,
    }));
    const after = withPoints(ring, { kind: "road", at: 0 }, points);
    const length = lineOf(points, true)?.length ?? 0;
    const last = after.roads[0]?.sections.at(-1);
    expect(last?.from_mm).toBeLessThan(length);
    expect(last?.to_mm).toBeNull();
    for (const dock of after.docks) expect(dock.at_mm).toBeLessThanOrEqual(length);
  });
});

describe("snapping", () => {
  it("goes to the grid, or to an end that is near", () => {
    expect(snapped(14, 26, [], 8)).toEqual({ x: 10, y: 30, end: false });
    expect(snapped(14, 26, [{ x: 13.5, y: 25 }], 8)).toEqual({ x: 13.5, y: 25, end: true });
    expect(snapped(14, 26, [{ x: 50, y: 25 }], 8).end).toBe(false);
    const { world } = added(EMPTY, "wall", { x1: 0, y1: 0, x2: 10, y2: 0 });
    expect(endsOf(world, []).length).toBe(2);
    expect(endsOf(world, [{ kind: "wall", at: 0 }])).toEqual([]);
  });
});

describe("a start that is dragged", () => {
  it("stays on the road near it, and stands on the floor far from it", () => {
    expect(startMoved(ring, 0, 350, 480).starts[0]).toMatchObject({ at: "road", road: "ring", at_mm: 100 });
    expect(startMoved(ring, 0, 600, 420).starts[0]).toMatchObject({ at: "pose", x_mm: 600, y_mm: 420, road: "" });
  });

  it("at a dock goes to the nearest dock, in a storehouse to another one", () => {
    expect(startMoved(ring, 3, 1000, 400).starts[3]).toMatchObject({ at: "dock", dock: "B" });
    expect(startMoved(ring, 5, 1000, 400).starts[5]).toMatchObject({ at: "storehouse", storehouse: "B" });
    expect(startMoved(ring, 5, 600, 400)).toBe(ring);
  });
});

describe("commands", () => {
  const base: Mission = {
    ...missionOf(CARRIER),
    agents: [{ name: "carrier-1", program: "carrier", start: "" }],
    goals: [{ storehouse: "B", stock: "all" }],
    world: "ring.world.xml",
  };

  beforeEach(() => useStudio.getState().openMission(fileOf(base)));

  it("bring the world, change it and go back; undo gives back what was there", () => {
    const { execute, undo } = useStudio.getState();
    const before = useStudio.getState().mission;
    execute(bringWorld(before, ring));
    expect(useStudio.getState().mission).toMatchObject({ world: "", own_world: ring });
    const change = changeOwnWorld(useStudio.getState().mission, "Move", moved(ring, { kind: "dock", at: 0 }, 0, 50));
    if (change === null) throw new Error("a dock moves");
    execute(change);
    expect(useStudio.getState().mission.own_world?.docks[0]?.at_mm).toBe(90);
    const back = changeWorld(useStudio.getState().mission, "ring.world.xml");
    if (back === null) throw new Error("there is another world");
    execute(back);
    expect(useStudio.getState().mission).toMatchObject({ world: "ring.world.xml", own_world: null });
    for (let step = 0; step < 3; step++) undo();
    expect(useStudio.getState().mission).toBe(before);
  });

  it("rename a thing for everybody who calls it by name", () => {
    const own = { ...base, world: "", own_world: ring };
    const house = renameThing(own, { kind: "storehouse", at: 1 }, "Shop")?.execute(own);
    expect(house?.own_world?.docks[1]?.storehouse).toBe("Shop");
    expect(house?.own_world?.starts[6]?.storehouse).toBe("Shop");
    expect(house?.goals).toEqual([{ storehouse: "Shop", stock: "all" }]);
    const road = renameThing(own, { kind: "road", at: 0 }, "loop")?.execute(own).own_world;
    expect(road?.docks.map((dock) => dock.road)).toEqual(["loop", "loop"]);
    expect(road?.starts[0]?.road).toBe("loop");
    const dock = renameThing(own, { kind: "dock", at: 0 }, "Quay")?.execute(own).own_world;
    expect(dock?.starts[3]?.dock).toBe("Quay");
    const start = renameThing(own, { kind: "start", at: 0 }, "here")?.execute(own);
    expect(start?.agents).toEqual([{ name: "carrier-1", program: "carrier", start: "here" }]);
    expect(renameThing(own, { kind: "road", at: 0 }, "")).toBeNull();
    expect(isFreeName(ring, "storehouse", "A")).toBe(false);
    expect(renameThing(own, { kind: "storehouse", at: 1 }, "A")).toBeNull();
    expect(renameThing(own, { kind: "wall", at: 0 }, "x")).toBeNull();
  });

  it("do nothing where there is nothing to do", () => {
    expect(changeOwnWorld(base, "x", ring)).toBeNull();
    const own = { ...base, world: "", own_world: ring };
    expect(changeOwnWorld(own, "x", { ...ring })).toBeNull();
    expect(removeThings(own, "x", [])).toBeNull();
  });
});
