import { describe, expect, it } from "vitest";

import type { OwnWorld } from "../types";
import { withStartsFor } from "./missing-starts";
import { drawnWorld } from "./drawing";
import { thingAt } from "./hit-test";
import { dragged, gripsOf } from "./grips";
import { drawNew } from "./part-creation";
import { anchorOf, moved } from "./part-movement";
import { partReferences } from "./part-reference";
import { removed } from "./part-edits";

const WORLD: OwnWorld = {
  name: "w",
  width_mm: 2000,
  height_mm: 1000,
  walls: [{ x1: 0, y1: 0, x2: 2000, y2: 0 }],
  floors: [],
  lines: [],
  roads: [],
  storehouses: [],
  docks: [],
  starts: [],
  boxes: [{ x_mm: 300, y_mm: 300, width_mm: 100, height_mm: 60, mass_g: 200, friction: 0.5 }],
  balls: [{ x_mm: 600, y_mm: 300, radius_mm: 40, mass_g: 50, friction: 0.02 }],
  zones: [
    { kind: "warm", x_mm: 1000, y_mm: 500, radius_mm: 200, width_mm: 0, height_mm: 0, value: 35, falloff_mm: 100 },
    { kind: "loud", x_mm: 1600, y_mm: 500, radius_mm: 0, width_mm: 300, height_mm: 200, value: 80, falloff_mm: 0 },
  ],
  unknown: [],
  label: {},
  help: {},
};
const [BOX, BALL, ROUND, SQUARE] = [
  { kind: "box", at: 0 },
  { kind: "ball", at: 0 },
  { kind: "zone", at: 0 },
  { kind: "zone", at: 1 },
] as const;

describe("what lies around its middle", () => {
  it("is found where it is, a zone only inside and under everything", () => {
    expect(thingAt(WORLD, 345, 325, 5)).toEqual(BOX);
    expect(thingAt(WORLD, 354, 300, 5)).toEqual(BOX);
    expect(thingAt(WORLD, 630, 330, 5)).toEqual(BALL);
    expect(thingAt(WORLD, 1190, 500, 5)).toEqual(ROUND);
    expect(thingAt(WORLD, 1204, 500, 5)).toBeNull();
    expect(thingAt(moved(WORLD, BOX, 700, 200), 1000, 500, 5)).toEqual(BOX);
    expect(thingAt(WORLD, 1000, 500, 5, ["box", "wall"])).toBeNull();
  });

  it("moves by its middle", () => {
    for (const thing of [BOX, BALL, ROUND, SQUARE]) {
      const before = anchorOf(WORLD, thing);
      const after = anchorOf(moved(WORLD, thing, 10, -20), thing);
      expect(after).toEqual({ x: (before?.x ?? 0) + 10, y: (before?.y ?? 0) - 20 });
    }
  });

  it("has grips for its size, a zone for how far it is felt", () => {
    expect(gripsOf(WORLD, BOX)).toEqual([{ id: "corner-of", x: 350, y: 330 }]);
    expect(gripsOf(WORLD, BALL)).toEqual([{ id: "radius", x: 640, y: 300 }]);
    expect(gripsOf(WORLD, ROUND).map(({ id }) => id)).toEqual(["radius", "falloff"]);
    // The lower left corner of a rectangle stays where it is.
    expect(dragged(WORLD, BOX, "corner-of", 450, 370).boxes?.[0]).toMatchObject({
      x_mm: 350,
      y_mm: 320,
      width_mm: 200,
      height_mm: 100,
    });
    expect(dragged(WORLD, BOX, "corner-of", -900, -900).boxes?.[0]).toMatchObject({ width_mm: 5, height_mm: 5 });
    expect(dragged(WORLD, BALL, "radius", 600, 350).balls?.[0]?.radius_mm).toBe(50);
    expect(dragged(WORLD, ROUND, "falloff", 0, 950).zones?.[0]?.falloff_mm).toBe(250);
    expect(dragged(WORLD, SQUARE, "falloff", 0, 300).zones?.[1]?.falloff_mm).toBe(0);
  });

  it("is drawn new from corner to corner, or as large as usual", () => {
    const drawn = drawNew(WORLD, "zone", { x: 100, y: 600 }, { x: 300, y: 700 });
    expect(drawn?.thing).toEqual({ kind: "zone", at: 2 });
    expect(drawn?.world.zones?.[2]).toMatchObject({ kind: "warm", x_mm: 200, y_mm: 650, radius_mm: 100 });
    expect(drawNew(WORLD, "box", { x: 100, y: 100 }, null)?.world.boxes?.[1]).toMatchObject({
      x_mm: 100,
      width_mm: 80,
    });
    expect(drawNew(WORLD, "ball", { x: 100, y: 100 }, null)?.world.balls?.[1]).toMatchObject({ radius_mm: 30 });
  });

  it("goes away, and a world that says nothing of it has none", () => {
    const left = removed(WORLD, [BOX, ROUND]);
    expect([left.boxes?.length, left.balls?.length, left.zones?.map(({ kind }) => kind)]).toEqual([0, 1, ["loud"]]);
    const { boxes: _, balls: __, zones: ___, ...bare } = WORLD;
    expect(partReferences(bare)).toEqual([{ kind: "wall", at: 0 }]);
    expect(drawnWorld(WORLD).zones).toEqual(WORLD.zones);
    expect(drawnWorld(bare).zones).toEqual([]);
  });
});

describe("a world to begin with", () => {
  const start = (name: string) => ({
    name,
    at: "pose" as const,
    road: "",
    at_mm: 0,
    dock: "",
    storehouse: "",
    x_mm: 100,
    y_mm: 100,
    heading_deg: 0,
  });

  it("gives its starts to the robots of the mission, and makes more where they are too few", () => {
    const template = { ...WORLD, starts: [start("robot-1"), start("robot-2")] };
    expect(withStartsFor(template, ["robot-1"])).toBe(template);
    const names = (robots: string[]) => withStartsFor(template, robots).starts.map(({ name }) => name);
    expect(names(["robot-1", "carrier"])).toEqual(["robot-1", "carrier"]);
    expect(names(["a", "b", "c", "c"])).toEqual(["a", "b", "c"]);
    expect(withStartsFor(template, ["a", "b", "c"]).starts[2]).toMatchObject({ x_mm: 1000, y_mm: 500 });
  });
});
