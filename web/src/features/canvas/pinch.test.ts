import { describe, expect, it } from "vitest";

import { pinched } from "./pinch";
import { LEAST_ZOOM, leastZoom } from "./zoom-range";

describe("two fingers", () => {
  const camera = { x: 10, y: 20, zoom: 1 };

  it("keep what is between them between them", () => {
    const next = pinched(camera, { x: 110, y: 120, far: 100 }, { x: 130, y: 100, far: 150 });
    expect(next.zoom).toBe(1.5);
    // The point of the graph that was under their middle.
    expect((130 - next.x) / next.zoom).toBeCloseTo(110 - 10);
    expect((100 - next.y) / next.zoom).toBeCloseTo(120 - 20);
  });

  it("stop where the zoom stops", () => {
    expect(pinched(camera, { x: 0, y: 0, far: 10 }, { x: 0, y: 0, far: 1000 }).zoom).toBe(2);
    expect(pinched(camera, { x: 0, y: 0, far: 1000 }, { x: 0, y: 0, far: 1 }).zoom).toBe(0.1);
  });
});

it("shows a program of a thousand rows whole, and a small one no smaller than before", () => {
  expect(leastZoom({ w: 800, h: 64_000 }) * 64_000).toBeLessThanOrEqual(400);
  expect(leastZoom({ w: 300, h: 200 })).toBe(LEAST_ZOOM);
  expect(leastZoom({ w: 0, h: 0 })).toBe(LEAST_ZOOM);
});
