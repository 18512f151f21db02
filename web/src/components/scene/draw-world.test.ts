import { describe, expect, it } from "vitest";

import type { World } from "../../model/types";
import { recordingBrush } from "../../testing/recording-pen";
import { fit } from "./camera";
import { drawWorld } from "./draw-world";
import type { Scene } from "./scene";

const WORLD: World = {
  name: "yard",
  width_mm: 1000,
  height_mm: 1000,
  walls: [{ x1: 0, y1: 0, x2: 1000, y2: 0 }],
  floors: [
    {
      colour: "red",
      points: [
        [100, 100],
        [300, 100],
        [300, 300],
        [100, 300],
        [100, 100],
      ],
    },
    {
      colour: "blue",
      points: [
        [200, 200],
        [400, 200],
        [300, 400],
        [200, 200],
      ],
    },
  ],
  lines: [
    {
      colour: "green",
      width_mm: 40,
      closed: false,
      points: [
        [0, 200],
        [900, 200],
      ],
    },
  ],
  roads: [],
  docks: [],
  storehouses: [],
  starts: [],
};
const ROOM = { width: 500, height: 500 };

/** What a pen is asked to fill and stroke, in order: the style that it has then, and the way of filling. */
function drawn(world: World): string[] {
  const { brush, asked } = recordingBrush(fit(world, ROOM, 0), ROOM);
  drawWorld(brush, { world, actors: [], stock: {} } as unknown as Scene);
  return asked.map(({ what, colour, rule }) => `${what} ${colour} ${rule}`.trim());
}

describe("the floor of a world", () => {
  it("is filled in its colours, the last on top, and the lines lie on it", () => {
    const asked = drawn(WORLD).filter((one) => /red|green|blue/.test(one));
    expect(asked).toEqual(["fill red evenodd", "fill blue evenodd", "stroke green"]);
  });

  it("needs no colours", () => {
    expect(drawn({ ...WORLD, floors: [] }).filter((one) => one.startsWith("fill"))).toEqual(["fill tile"]);
  });
});
