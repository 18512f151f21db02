import { describe, expect, it } from "vitest";

import { layoutStructure } from "../../model/layout";
import { readStructure } from "../../model/structure";
import { CARRIER, CARRIER_PARTS as PARTS } from "../../model/testing/missions";
import type { Size } from "./camera";
import { afterResize, homeOf, LEAST_READABLE, wholeOf } from "./home";

const layout = layoutStructure(readStructure(CARRIER, PARTS));
const carrier = { layout, nodes: new Map(layout.nodes.map((node) => [node.id, node])) };
const { w, h } = layout.bounds;

/** The program's edges on the canvas, in px. */
function edges(size: Size, least = LEAST_READABLE) {
  const { x, y, zoom } = wholeOf(size, carrier, least);
  const { bounds } = layout;
  const [left, top] = [x + bounds.x * zoom, y + bounds.y * zoom];
  return { zoom, left, top, right: size.width - left - w * zoom, bottom: size.height - top - h * zoom };
}

describe("a program opens", () => {
  it("at full size where it fits", () => {
    const size = { width: w + 400, height: h + 400 };
    expect(edges(size).zoom).toBe(1);
    expect(wholeOf(size, carrier, 0.5)).toEqual(homeOf(size, carrier));
  });

  it.each([
    ["too low", { width: w + 400, height: h * 0.8 + 82 }],
    ["too narrow", { width: w * 0.8 + 32, height: h + 400 }],
    ["both", { width: w * 0.75 + 32, height: h * 0.75 + 82 }],
  ])("whole in a view that is %s, clear of the edges and of the zoom control", (_, size) => {
    const { zoom, left, top, right, bottom } = edges(size);
    expect(zoom).toBeLessThan(1);
    expect(zoom).toBeGreaterThan(0.7);
    expect(Math.min(left, top, right)).toBeGreaterThanOrEqual(15);
    expect(bottom).toBeGreaterThanOrEqual(63);
  });

  it("at its Start, as wide as fits, where it could not be read whole", () => {
    expect(edges({ width: w + 400, height: h / 2 })).toMatchObject({
      zoom: 1,
      top: edges({ width: 4000, height: 4000 }).top,
    });
    expect(edges({ width: w * 0.8 + 32, height: h / 2 }).zoom).toBeCloseTo(0.8);
    const phone = { width: w / 4, height: h / 2 };
    expect(wholeOf(phone, carrier, LEAST_READABLE)).toMatchObject({ zoom: 0.7, x: Math.round(phone.width / 2) });
  });

  it("at full size where nothing may be smaller", () => {
    const size = { width: w * 0.8, height: h * 0.8 };
    expect(wholeOf(size, carrier, 1)).toEqual(homeOf(size, carrier));
  });

  it("smaller where that is asked for", () => {
    expect(edges({ width: w * 0.6 + 32, height: h + 400 }, 0.5).zoom).toBeCloseTo(0.6);
  });
});

describe("a canvas of another width", () => {
  const [wide, narrow] = [
    { width: w + 400, height: h + 400 },
    { width: w * 0.9, height: h + 400 },
  ];
  const shown = { camera: wholeOf(wide, carrier, 0.7), least: 0.7 };

  it("shows the whole program where it was shown, and so at the next width", () => {
    const { camera, whole } = afterResize(shown.camera, wide.width, narrow, carrier, shown);
    expect(camera).toEqual(wholeOf(narrow, carrier, 0.7));
    expect(afterResize(camera, narrow.width, wide, carrier, whole).camera).toEqual(shown.camera);
  });

  it("keeps in the middle what somebody moved there", () => {
    const moved = { ...shown.camera, x: shown.camera.x + 30 };
    const after = afterResize(moved, wide.width, narrow, carrier, shown);
    expect(after).toEqual({ camera: { ...moved, x: moved.x + (narrow.width - wide.width) / 2 }, whole: null });
  });
});
