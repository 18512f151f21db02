import { afterEach, expect, test, vi } from "vitest";

import { createCamera, zoomed } from "./camera";

const SIZE = { width: 400, height: 300 };

/** Runs the frames of the page until nothing moves any more. */
function frames(reduced: boolean): (time: number) => void {
  let next: ((time: number) => void) | null = null;
  vi.stubGlobal("matchMedia", () => ({ matches: reduced }));
  vi.stubGlobal("requestAnimationFrame", (step: (time: number) => void) => ((next = step), 1));
  vi.stubGlobal("cancelAnimationFrame", () => (next = null));
  vi.spyOn(performance, "now").mockReturnValue(0);
  return (time) => {
    const step = next;
    next = null;
    step?.(time);
  };
}
afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

test("a point of the graph and its place on the canvas are each other's way back", () => {
  const camera = createCamera({ x: 10, y: -20, zoom: 0.5 }, SIZE);
  const place = camera.place({ x: 100, y: 60 });
  expect(place).toEqual({ x: 60, y: 10 });
  expect(camera.point({ x: place.x + 7, y: place.y + 9 }, { left: 7, top: 9 })).toEqual({ x: 100, y: 60 });
});

test("a zoom keeps what it is asked to keep", () => {
  expect(zoomed({ x: 0, y: 0, zoom: 1 }, 2, { x: 50, y: 30 })).toEqual({ x: -50, y: -30, zoom: 2 });
});

test("a glide comes by between and ends exactly there", () => {
  const frame = frames(false);
  const camera = createCamera({ x: 0, y: 0, zoom: 1 }, SIZE);
  camera.glide({ x: 100, y: 50, zoom: 2 });
  frame(70);
  expect(camera.now()).toEqual({ x: 50, y: 25, zoom: 1.5 });
  frame(200);
  expect(camera.now()).toEqual({ x: 100, y: 50, zoom: 2 });
});

test("a hand that moves the canvas ends a glide", () => {
  const frame = frames(false);
  const camera = createCamera({ x: 0, y: 0, zoom: 1 }, SIZE);
  camera.glide({ x: 100, y: 50, zoom: 2 });
  camera.pan(3, 4);
  frame(200);
  expect(camera.now()).toEqual({ x: 3, y: 4, zoom: 1 });
});

test("who wants less motion is there at once", () => {
  frames(true);
  const camera = createCamera({ x: 0, y: 0, zoom: 1 }, SIZE);
  camera.glide({ x: 100, y: 50, zoom: 2 });
  expect(camera.now()).toEqual({ x: 100, y: 50, zoom: 2 });
});
