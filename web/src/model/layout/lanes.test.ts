import { describe, expect, it } from "vitest";

import { readStructure } from "../structure";
import { CARRIER, CARRIER_PARTS } from "../testing/missions";
import { LANE, layoutStructure } from ".";

const structure = readStructure(CARRIER, CARRIER_PARTS);
const plain = layoutStructure(structure);
const bar = plain.nodes.find(({ kind }) => kind === "bar");
const BRANCHES = structure.main.chain
  .flatMap((block) => [block, ...block.bodies.flatMap(({ chain }) => chain)])
  .find(({ vertex }) => vertex.id === bar?.vertex)
  ?.bodies.map(({ chain }) => chain.map(({ vertex }) => vertex.id));

describe("lanes", () => {
  const [first = [], ...others] = BRANCHES ?? [];
  const acting = new Map([[first[0] ?? "", ["loading", "carrier-1", "loading"]]]);
  const drawn = layoutStructure(structure, new Set(), acting);

  it("are the branches of a parallel in which somebody acts, side by side over its whole width", () => {
    expect(plain.lanes).toEqual([]);
    const frame = drawn.frames.find(({ id }) => id === bar?.vertex);
    expect(drawn.lanes).toHaveLength(1 + others.length);
    expect(drawn.lanes.map(({ first: begins }) => begins)).toEqual([true, ...others.map(() => false)]);
    expect(drawn.lanes[0]?.x).toBe(frame?.x);
    drawn.lanes.slice(1).forEach(({ x }, index) => {
      const before = drawn.lanes[index];
      expect(x).toBe((before?.x ?? 0) + (before?.w ?? 0));
    });
    expect(drawn.lanes.reduce((sum, { w }) => sum + w, 0)).toBe(frame?.w);
  });

  it("name each who acts in them once, those in which nobody does too", () => {
    expect(drawn.lanes.map(({ names }) => names)).toEqual([["loading", "carrier-1"], ...others.map(() => [])]);
  });

  it("hold every vertex of their branch below their head, and move nothing else but down", () => {
    BRANCHES?.forEach((ids, index) => {
      const lane = drawn.lanes[index];
      for (const node of drawn.nodes.filter(({ id }) => ids.includes(id))) {
        expect(node.x).toBeGreaterThanOrEqual(lane?.x ?? NaN);
        expect(node.x + node.w).toBeLessThanOrEqual((lane?.x ?? NaN) + (lane?.w ?? NaN));
        expect(node.y).toBeGreaterThanOrEqual((lane?.y ?? NaN) + LANE);
      }
    });
    expect(drawn.nodes.map(({ id, x }) => [id, x])).toEqual(plain.nodes.map(({ id, x }) => [id, x]));
    expect((drawn.nodes.at(-1)?.y ?? 0) - (plain.nodes.at(-1)?.y ?? 0)).toBe(40);
  });
});
