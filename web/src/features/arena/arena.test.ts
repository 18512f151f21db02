import { beforeAll, describe, expect, it } from "vitest";

import { fit, fitBox, toScreen, toWorld, zoomAt } from "../../components/scene/camera";
import { isCrowd } from "../../components/scene/crowd-size";
import { ringOf } from "../../components/scene/draw-robots";
import { robotUnit } from "../../components/scene/draw-world";
import { contentOf } from "../../components/scene/framing";
import { nearestOn, placeAlong, roadLength, signAt } from "../../components/scene/geometry";
import { hasOtherPlaces, lookAt, roleAt, sceneBefore, sceneOfReal, totalOf } from "../../components/scene/scene";
import { placeTag } from "../../components/scene/tag-place";
import { moreWords } from "../../i18n/words";
import type { Mission, World } from "../../model/types";
import { newStates } from "./stage/states-said";
import { summary } from "./summary";

beforeAll(moreWords);

const WORLD: World = {
  name: "square",
  width_mm: 1200,
  height_mm: 1200,
  walls: [],
  floors: [],
  lines: [],
  roads: [
    {
      name: "ring",
      width_mm: 100,
      closed: true,
      points: [
        [200, 200],
        [1000, 200],
        [1000, 1000],
        [200, 1000],
      ],
      sections: [
        { sign: 0, from_mm: 0, to_mm: 800 },
        { sign: 1, from_mm: 800, to_mm: 3200 },
      ],
    },
  ],
  docks: [
    {
      name: "A",
      road: "ring",
      at_mm: 400,
      reach_mm: 30,
      storehouse: "A",
      kind: "load",
      x_mm: 600,
      y_mm: 200,
      heading_rad: 0,
    },
  ],
  storehouses: [
    { name: "A", x_mm: 500, y_mm: 0, width_mm: 200, height_mm: 90, capacity: 12, stock: 12 },
    { name: "B", x_mm: 500, y_mm: 1100, width_mm: 200, height_mm: 90, capacity: 12, stock: 2 },
  ],
  starts: [
    { name: "c-1", x_mm: 300, y_mm: 200, heading_rad: 0 },
    { name: "arm", x_mm: 600, y_mm: 110, heading_rad: 1.57 },
    { name: "boss", x_mm: 600, y_mm: 45, heading_rad: 0 },
  ],
};
const ROAD = WORLD.roads[0];
const MISSION: Mission = {
  version: 1,
  programs: [],
  agents: [
    { name: "c-1", program: "carrier", start: "" },
    { name: "loader", program: "loader", start: "arm" },
    { name: "boss", program: "boss", start: "" },
    { name: "lost", program: "carrier", start: "nowhere" },
  ],
  goals: [{ storehouse: "B", stock: "all" }],
  world: "square.world.xml",
};

describe("places on a road", () => {
  if (ROAD === undefined) throw new Error("the world has a road");

  it("count the way back to the first point of a closed road", () => {
    expect(roadLength(ROAD)).toBe(3200);
  });

  it("are found by the distance along, round and round", () => {
    expect(placeAlong(ROAD, 400)).toEqual({ x: 600, y: 200, heading: 0 });
    expect(placeAlong(ROAD, 3600)).toEqual({ x: 600, y: 200, heading: 0 });
    expect(placeAlong(ROAD, -400)?.y).toBe(600);
  });

  it("are found from beside the road", () => {
    expect(nearestOn(ROAD, 600, 230)).toEqual({ along: 400, off: 30 });
  });

  it("tell the section, and none off the road", () => {
    expect(signAt(WORLD, 600, 240)).toBe(0);
    expect(signAt(WORLD, 1000, 600)).toBe(1);
    expect(signAt(WORLD, 600, 600)).toBeNull();
  });

  it("are none on a road without length", () => {
    expect(placeAlong({ ...ROAD, points: [] }, 5)).toBeNull();
  });
});

describe("the camera", () => {
  const room = { width: 480, height: 336 };

  it("fits the whole world into the panel", () => {
    const camera = fit(WORLD, room, 0);
    expect(toScreen(camera, 0, 1200)[1]).toBeCloseTo(0);
    expect(toScreen(camera, 0, 0)[1]).toBeCloseTo(336);
    expect(toScreen(camera, 600, 600)[0]).toBeCloseTo(240);
  });

  it("comes back from the screen", () => {
    const camera = fit(WORLD, room, 20);
    const [x, y] = toScreen(camera, 123, 456);
    expect(toWorld(camera, x, y)[0]).toBeCloseTo(123);
    expect(toWorld(camera, x, y)[1]).toBeCloseTo(456);
  });

  it("zooms around the point under the hand, within limits", () => {
    const whole = fit(WORLD, room, 0);
    const near = zoomAt(whole, whole, 2, 100, 50);
    expect(toWorld(near, 100, 50)).toEqual(toWorld(whole, 100, 50));
    expect(zoomAt(whole, whole, 1e6, 0, 0).scale).toBeCloseTo(whole.scale * 8);
    expect(zoomAt(whole, whole, 1e-6, 0, 0).scale).toBeCloseTo(whole.scale / 4);
  });
});

describe("the scene before a run", () => {
  const scene = sceneBefore(MISSION, WORLD);

  it("shows each agent as what it is", () => {
    expect(scene.actors.map((actor) => actor.role)).toEqual(["robot", "arm", "keeper"]);
  });

  it("takes somebody close to a dock, but on the road, for a robot", () => {
    expect(roleAt(WORLD, 660, 200)).toBe("robot");
  });

  it("leaves out an agent that has no place to start", () => {
    expect(scene.actors.map((actor) => actor.name)).not.toContain("lost");
  });

  it("counts what has to be delivered", () => {
    expect(scene.total).toBe(12);
    expect(totalOf(WORLD, [{ storehouse: "B", stock: "5" }])).toBe(5);
    expect(totalOf(WORLD, [{ storehouse: "B", stock: "some" }])).toBe(0);
  });

  it("is said in words", () => {
    expect(summary(scene, lookAt(scene, null))).toBe("0 of 12 delivered. Stock: A 12, B 2. c-1 at section 0.");
  });

  it("says load and failure of a robot", () => {
    const poses = [{ x_mm: 1000, y_mm: 600, heading_rad: 0, load: 1, flags: 2 }];
    expect(summary(scene, lookAt(scene, poses))).toContain("c-1 at section 1, loaded, failed.");
  });
});

describe("a mission that was edited since its run", () => {
  const one: Mission = {
    version: 1,
    programs: [],
    agents: [{ name: "a", program: "p", start: "" }],
    goals: [],
    world: "w",
  };

  it("has other places when its team or its world is another", () => {
    expect(hasOtherPlaces({ ...one, agents: [] }, one)).toBe(true);
    expect(hasOtherPlaces({ ...one, agents: [{ name: "a", program: "p", start: "b" }] }, one)).toBe(true);
    expect(hasOtherPlaces({ ...one, world: "v" }, one)).toBe(true);
  });

  it("has the same ones whatever else was edited, and once more after undo", () => {
    expect(hasOtherPlaces({ ...one, goals: [{ storehouse: "A", stock: "all" }] }, one)).toBe(false);
    expect(hasOtherPlaces({ ...one, agents: [{ name: "a", program: "p", start: "" }], own_world: null }, one)).toBe(
      false,
    );
  });
});

describe("the tag", () => {
  const room = { width: 480, height: 336 };
  const size = { width: 100, height: 24 };

  it("stands at the lower right where there is room", () => {
    expect(placeTag(100, 100, 30, size, room, [])).toMatchObject({ right: 1, below: 1 });
  });

  it("goes to another corner where something stands in the way", () => {
    const house = { left: 130, top: 100, width: 120, height: 60 };
    expect(placeTag(100, 100, 30, size, room, [house])).not.toMatchObject({ right: 1, below: 1 });
  });

  it("says what it costs to stand where something is, or away from where it belongs", () => {
    const all = { left: 0, top: 0, ...room };
    expect(placeTag(100, 100, 30, size, room, []).cost).toBe(0);
    expect(placeTag(100, 100, 30, size, room, [all]).cost).toBeGreaterThan(0);
    expect(placeTag(240, 100, 30, { width: 400, height: 24 }, room, []).cost).toBeGreaterThan(0);
  });

  it("stays inside the arena", () => {
    const { area } = placeTag(475, 330, 30, size, room, []);
    expect(area.left + area.width).toBeLessThanOrEqual(472);
    expect(area.top + area.height).toBeLessThanOrEqual(328);
  });
});

describe("what befalls robots", () => {
  const well = { x_mm: 300, y_mm: 200, heading_rad: 0, load: 0, flags: 0 };
  const scene = sceneBefore(MISSION, WORLD);

  it("is told apart in words", () => {
    const said = (flags: number) => summary(scene, lookAt(scene, [{ ...well, flags }]));
    expect(said(2)).toContain("c-1 at section 0, failed.");
    expect(said(32)).toContain("c-1 at section 0, stalled.");
    expect(said(64)).toContain("c-1 at section 0, without radio.");
    expect(said(32 | 64)).toContain("stalled, without radio.");
  });

  it("is said once when it is new, and when it is over", () => {
    const none = new Map<string, string>();
    const failed = new Map([["c-1", "failed"]]);
    expect(newStates(none, failed)).toEqual(["c-1: failed"]);
    expect(newStates(failed, failed)).toEqual([]);
    expect(newStates(failed, none)).toEqual(["c-1: well again"]);
  });

  it("counts a crowd instead of telling of each, and names only who failed", () => {
    const agents = Array.from({ length: 300 }, (_, n) => ({ name: `r${String(n)}`, program: "p", start: "c-1" }));
    const crowd = sceneBefore({ ...MISSION, agents }, WORLD);
    const words = summary(crowd, lookAt(crowd, [{ ...well, flags: 2 }]));
    expect(words).toContain("300 robots.");
    expect(words).toContain("r0 at section 0, failed.");
    expect(words).not.toContain("r1 ");
  });

  it("is drawn simply where many robots are small", () => {
    expect(isCrowd(2000, 0.03)).toBe(true);
    expect(isCrowd(2000, 1)).toBe(false);
    expect(isCrowd(20, 0.03)).toBe(false);
  });
});

it("shows the world of real robots without them: nobody knows where they are", () => {
  const scene = sceneOfReal(WORLD);
  expect([scene.real, scene.actors, scene.stock, sceneBefore(MISSION, WORLD).real]).toEqual([
    true,
    [],
    { A: 12, B: 2 },
    false,
  ]);
  expect(lookAt(scene, [{ x_mm: 0, y_mm: 0, heading_rad: 0, load: 0, flags: 0 }])).toEqual([]);
});

describe("what a world opens with", () => {
  const YARD: World = {
    ...WORLD,
    width_mm: 4000,
    height_mm: 4000,
    roads: [],
    docks: [],
    storehouses: [],
    starts: [{ name: "r", x_mm: 500, y_mm: 500, heading_rad: 0 }],
    walls: [{ x1: 300, y1: 300, x2: 900, y2: 300 }],
  };
  const room = { width: 400, height: 400 };

  it("is what is there, with room around it, inside the world", () => {
    const content = contentOf(YARD, []);
    expect([content.left, content.right, content.bottom]).toEqual([150, 1050, 150]);
    // A robot is half as long as its room above the start.
    expect(content.top).toBeCloseTo(583.7);
    expect(contentOf(YARD, [{ x_mm: 3990, y_mm: 500 }]).right).toBe(4000);
    expect(fitBox(contentOf(YARD, []), room, 0).scale).toBeCloseTo(400 / 900);
  });

  it("is the whole world where robots are alone", () => {
    expect(contentOf({ ...YARD, walls: [] }, [])).toEqual({ left: 0, right: 4000, bottom: 0, top: 4000 });
  });

  it("is not larger than two px a mm", () => {
    expect(fit({ width_mm: 20, height_mm: 20 }, room, 0).scale).toBe(2);
    expect(toScreen(fit({ width_mm: 20, height_mm: 20 }, room, 0), 10, 10)).toEqual([200, 200]);
  });
});

describe("the size of a robot", () => {
  it("is its own, however small that is", () => {
    const { scale } = fit({ width_mm: 4000, height_mm: 2500 }, { width: 370, height: 300 }, 26);
    for (const length of [60, 135, 400]) {
      expect(54 * robotUnit({ scale, x: 0, y: 0 }, length)).toBeCloseTo(length * scale);
    }
  });

  it("does not make the ring around it too small to be seen", () => {
    expect(ringOf({ role: "robot" }, 0.1)).toBe(13);
    expect(ringOf({ role: "robot" }, 1)).toBe(37);
  });

  it("comes from its kind, and is that of most robots where the kind has none", () => {
    const robots = [{ name: "mini", label: {}, help: {}, tick_ms: 20, wait_unit_ms: 100, objects: [], length_mm: 60 }];
    const mission: Mission = {
      ...MISSION,
      programs: [
        { name: "a", robot: "mini", vertices: [], arcs: [] },
        { name: "b", robot: "board", vertices: [], arcs: [] },
      ],
      agents: [
        { name: "x", program: "a", start: "c-1" },
        { name: "y", program: "b", start: "boss" },
      ],
    };
    const { actors } = sceneBefore(mission, { ...WORLD }, { groups: [], robots, problems: [] });
    expect(actors.map(({ length_mm, free }) => [length_mm, free])).toEqual([
      [60, false],
      [135, true],
    ]);
  });
});
