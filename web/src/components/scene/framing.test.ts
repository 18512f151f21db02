import { describe, expect, it } from "vitest";

import type { World } from "../../model/types";
import { fitBox, toScreen } from "./camera";
import {
  around,
  atLeast,
  cameraBetween,
  contentOf,
  EMPTY,
  isEmpty,
  isOnScreen,
  sightsOf,
  subjectOf,
  union,
} from "./framing";
import { Viewpoint } from "./viewpoint";

const ROOM = { width: 500, height: 600 };
const WHOLE = { scale: 0.1, x: 0, y: 0 };
const NONE = { walls: [], roads: [], lines: [], floors: [], storehouses: [], docks: [], starts: [] };
const room: World = { name: "room", width_mm: 4000, height_mm: 2500, ...NONE };
const edges = [
  { x1: 0, y1: 0, x2: 4000, y2: 0 },
  { x1: 4000, y1: 0, x2: 4000, y2: 2500 },
];
const robot = (x_mm: number, y_mm: number) => ({ x_mm, y_mm, length_mm: 100 });

describe("what there is to see", () => {
  it("is nothing in an empty room, whose walls are its edges, and a wall or a thing that stands in it", () => {
    expect(isEmpty(sightsOf({ ...room, walls: edges }))).toBe(true);
    const inner = sightsOf({ ...room, walls: [...edges, { x1: 1000, y1: 500, x2: 1000, y2: 900 }] });
    expect([inner.left, inner.right, inner.bottom, inner.top]).toEqual([850, 1150, 350, 1050]);
    const ball = { kind: "ball" as const, x_mm: 100, y_mm: 900, width_mm: 40, height_mm: 40 };
    expect(sightsOf({ ...room, things: [ball] }).left).toBe(0);
  });

  it("is the robots and where they have been, and everything in a small world and of a crowd", () => {
    const been = union(around(500, 500, 0), around(900, 900, 0));
    expect(subjectOf(room, [robot(500, 500)], been, WHOLE, ROOM)).toEqual({
      left: 438,
      right: 900,
      bottom: 438,
      top: 900,
    });
    expect(subjectOf(room, [robot(500, 500)], been, { ...WHOLE, scale: 0.5 }, ROOM)).toBeNull();
    expect(subjectOf(room, [], been, WHOLE, ROOM)).toBeNull();
    expect(
      subjectOf(
        room,
        Array.from({ length: 25 }, () => robot(1, 1)),
        EMPTY,
        WHOLE,
        ROOM,
      ),
    ).toBeNull();
  });

  it("is everything where the camera on that is nearer, unless a robot has left it", () => {
    const road = {
      name: "road",
      points: [
        [400, 400],
        [1000, 400],
      ],
      width_mm: 200,
      closed: false,
      radius_mm: 0,
    };
    const world = { ...room, roads: [road] } as unknown as World;
    expect(sightsOf(world)).toEqual({ left: 250, right: 1150, bottom: 250, top: 550 });
    const small = { width: 300, height: 150 };
    const whole = fitBox(contentOf(world, []), small, 0);
    expect(subjectOf(world, [robot(700, 400)], EMPTY, whole, small)).toBeNull();
    expect(subjectOf(world, [robot(700, 900)], EMPTY, whole, small)?.top).toBe(962);
    expect(subjectOf(world, [robot(700, 400)], EMPTY, WHOLE, small)).toEqual(sightsOf(world));
  });

  it("has a least size around the same middle", () => {
    expect(atLeast(around(100, 100, 10), 400)).toEqual(around(100, 100, 200));
    expect(atLeast(around(100, 100, 300), 400, 1.5)).toEqual(around(100, 100, 450));
  });

  it("is on the screen or not, margin and all", () => {
    const camera = fitBox(around(0, 0, 1000), ROOM, 20);
    expect(isOnScreen(around(0, 0, 1000), camera, ROOM, 20)).toBe(true);
    expect(isOnScreen(around(0, 0, 1010), camera, ROOM, 20)).toBe(false);
  });

  it("is moved to in between, and reached", () => {
    const [from, to] = [WHOLE, { scale: 1, x: 100, y: 50 }];
    expect(cameraBetween(from, to, 0)).toEqual(from);
    expect(cameraBetween(from, to, 0.5).x).toBe(50);
    expect(cameraBetween(from, to, 1)).toBe(to);
  });
});

describe("the camera", () => {
  /** A camera on a robot, with a clock of its own. */
  function watching() {
    const at = { x: 1000, clock: 0 };
    const subject = () => around(at.x, 1000, 60);
    const viewpoint = new Viewpoint({ whole: () => WHOLE, subject }, () => at.clock);
    viewpoint.jump(ROOM);
    return { at, viewpoint, place: () => toScreen(viewpoint.camera, at.x, 1000)[0] };
  }

  it("stays while the robot is on the screen, and comes after it when it leaves", () => {
    const { at, viewpoint, place } = watching();
    const before = viewpoint.camera;
    at.x = 1200;
    expect(viewpoint.step(true, false)).toBe(false);
    expect(viewpoint.camera).toBe(before);
    at.x = 2500;
    expect(place()).toBeGreaterThan(ROOM.width);
    viewpoint.step(true, false);
    expect(place()).toBe(ROOM.width / 2);
  });

  it("eases there unless somebody wants no motion", () => {
    const { at, viewpoint, place } = watching();
    at.x = 2500;
    expect(viewpoint.step(true, true)).toBe(true);
    const far = place();
    at.clock = 160;
    expect(viewpoint.step(true, true)).toBe(true);
    expect(place()).toBeLessThan(far);
    at.clock = 400;
    expect(viewpoint.step(true, true)).toBe(false);
    expect(place()).toBe(ROOM.width / 2);
  });

  it("is left where a hand took it until somebody asks for what matters, and asked again shows everything", () => {
    const { at, viewpoint, place } = watching();
    const taken = { scale: 2, x: 5, y: 5 };
    viewpoint.take(taken);
    at.x = 2500;
    viewpoint.setOpen(false);
    viewpoint.setCovered(100);
    viewpoint.jump({ width: 400, height: 600 });
    viewpoint.step(true, false);
    expect(viewpoint.camera).toBe(taken);
    viewpoint.showAll();
    viewpoint.step(false, false);
    expect(place()).toBe(200);
    viewpoint.showAll();
    viewpoint.step(false, false);
    expect(viewpoint.camera).toBe(WHOLE);
    viewpoint.showSubject();
    viewpoint.step(false, false);
    expect(place()).toBe(200);
  });

  it("looks closely at what a run did once it is over, above what covers the arena", () => {
    const { viewpoint } = watching();
    const open = viewpoint.camera.scale;
    viewpoint.setOpen(false);
    viewpoint.setCovered(200);
    viewpoint.step(false, false);
    expect(viewpoint.camera.scale).toBeGreaterThan(open);
    expect(toScreen(viewpoint.camera, 1000, 1000)[1]).toBe(200);
  });
});
