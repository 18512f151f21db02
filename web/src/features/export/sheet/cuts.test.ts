import { describe, expect, it } from "vitest";

import type { Layout, LayoutNode } from "../../../model/layout";
import { cuts, type Paper, partsOf, wholePage } from "./cuts";

const stack = (count: number, tall = 50, gap = 30) =>
  Array.from({ length: count }, (_, index) => ({ from: index * (tall + gap), to: index * (tall + gap) + tall }));

describe("cuts", () => {
  it("leaves whole what fits", () => {
    expect(cuts(0, 100, () => 100, stack(1))).toEqual([{ from: 0, to: 100 }]);
  });

  it("cuts between things, and leaves nothing out", () => {
    const solid = stack(40);
    const parts = cuts(0, 3200, () => 500, solid);
    expect(parts[0]?.from).toBe(0);
    expect(parts.at(-1)?.to).toBe(3200);
    for (const [index, part] of parts.entries()) {
      expect(part.to - part.from).toBeLessThanOrEqual(500);
      if (index > 0) expect(part.from).toBe(parts[index - 1]?.to);
      expect(solid.some((one) => one.from < part.to && one.to > part.to)).toBe(false);
    }
  });

  it("cuts through something that is longer than a page", () => {
    expect(cuts(0, 1000, () => 400, [{ from: 0, to: 1000 }]).map(({ to }) => to)).toEqual([400, 800, 1000]);
  });

  it("gives the first part less room where a heading stands", () => {
    expect(cuts(0, 250, (index) => (index === 0 ? 50 : 100), []).map(({ to }) => to)).toEqual([50, 150, 250]);
  });
});

const PAPER: Paper = { width: 680, height: 890, heading: 64, largest: 0.8, smallest: 0.4 };

function layoutOf(columns: number, rows: number): Layout {
  const nodes = Array.from({ length: columns * rows }, (_, index): LayoutNode => {
    const place = { x: (index % columns) * 260, y: Math.floor(index / columns) * 80, w: 200, h: 44 };
    return { id: String(index), note: "", ...place } as LayoutNode;
  });
  const bounds = { x: 0, y: 0, w: columns * 260 - 60, h: rows * 80 - 36 };
  return { nodes, arcs: [], frames: [], lanes: [], leaps: [], bounds };
}

describe("a graph on paper", () => {
  it.each([
    [1, 1, 1],
    [3, 5, 1],
    // A little too tall for one page at full size: rather a little smaller.
    [1, 15, 1],
  ])("of %i × %i takes one page", (columns, rows, pages) => {
    const parts = partsOf(layoutOf(columns, rows), PAPER, 32);
    expect(parts).toHaveLength(pages);
    expect(parts.every(({ width }) => width <= PAPER.width + 1)).toBe(true);
  });

  it.each([
    [1, 1000],
    [20, 30],
    [12, 3],
  ])("of %i × %i shows each vertex whole on some page, none larger than the paper", (columns, rows) => {
    const layout = layoutOf(columns, rows);
    const parts = partsOf(layout, PAPER, 32);
    const whole = new Set(
      parts.flatMap(({ layout: { bounds, nodes } }) =>
        nodes
          .filter(
            ({ x, y, w, h }) =>
              x >= bounds.x - 32 &&
              x + w <= bounds.x + bounds.w + 32 &&
              y >= bounds.y - 32 &&
              y + h <= bounds.y + bounds.h + 32,
          )
          .map(({ id }) => id),
      ),
    );
    expect(whole.size).toBe(columns * rows);
    for (const { layout: part, width } of parts) {
      const scale = width / (part.bounds.w + 64);
      expect(width).toBeLessThanOrEqual(PAPER.width + 1);
      expect((part.bounds.h + 64) * scale).toBeLessThanOrEqual(PAPER.height + 1);
      expect(scale).toBeGreaterThanOrEqual(PAPER.smallest - 1e-9);
    }
  });
});

describe("a graph that is shown whole", () => {
  const papers = [
    { width: 680, height: 910, heading: 60, largest: 0.8, smallest: 0.4 },
    { width: 940, height: 640, heading: 60, largest: 0.8, smallest: 0.4 },
  ];
  const on = (w: number, h: number) => {
    const { paper, width } = wholePage({ bounds: { x: 0, y: 0, w: w - 64, h: h - 64 } }, papers, 32);
    return [papers.indexOf(paper), width];
  };

  it("is as large as its words need, and upright where both are the same", () => {
    expect(on(500, 600)).toEqual([0, 400]);
  });

  it("is as small as its page needs, however small that is", () => {
    expect(on(500, 85_000)).toEqual([0, 5]);
  });

  it("lies on its side where it is larger there", () => {
    expect(on(2350, 400)).toEqual([1, 940]);
  });
});
