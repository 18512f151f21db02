import { describe, expect, it } from "vitest";

import { readStructure } from "../../model/structure";
import { CARRIER, CARRIER_PARTS } from "../../model/testing/missions";
import { findSpot } from "../../model/tree";
import type { Program } from "../../model/types";
import { waitedVertices } from "./Nodes";

function waited(program: Program, id: string): string[] {
  const spot = findSpot(readStructure(program, CARRIER_PARTS), id);
  if (spot === undefined) throw new Error(`no vertex ${id}`);
  return waitedVertices(spot.block);
}

describe("the end of a parallel", () => {
  it("waits for the branches without a mark", () => {
    expect(waited(CARRIER, "v3")).toEqual(["v4", "v5", "v6"]);
  });

  it("waits for all of them where each has a mark", () => {
    const vertices = CARRIER.vertices.map((one) => (one.id === "v4" ? { ...one, element: "Interrupt" } : one));
    const arcs = CARRIER.arcs
      .filter((one) => !["v5", "v4", "v6"].includes(one.source) || one.target === "v3")
      .concat({ source: "v6", target: "v4", out: "next", at: "action" });
    const all = waited({ ...CARRIER, vertices: vertices.filter((one) => one.id !== "v5"), arcs }, "v3");
    expect(all).toContain("v4");
    expect(all).toContain("v9");
  });

  it("counts a parallel in a branch as one vertex", () => {
    const inner = { id: "v30", element: "Parallelism", settings: {}, notes: [] };
    const held = { id: "v31", element: "Lamp.LightOff", settings: {}, notes: [] };
    const program: Program = {
      ...CARRIER,
      vertices: [...CARRIER.vertices, inner, held],
      arcs: [
        ...CARRIER.arcs.filter((one) => one.source !== "v6"),
        { source: "v6", target: "v30", out: "next", at: "in" },
        { source: "v30", target: "v31", out: "branch.1", at: "in" },
        { source: "v31", target: "v30", out: "next", at: "return" },
        { source: "v30", target: "v4", out: "next", at: "return" },
      ],
    };
    expect(waited(program, "v3")).toEqual(["v4", "v5", "v6", "v30"]);
  });
});
