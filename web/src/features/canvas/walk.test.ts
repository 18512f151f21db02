import { describe, expect, it } from "vitest";

import { emptyProgram } from "../../model/commands/changePrograms";
import { insertPart } from "../../model/commands/insertPart";
import { layoutStructure } from "../../model/layout";
import { readStructure } from "../../model/structure";
import { CARRIER, CARRIER_PARTS as PARTS, WAITING_PARTS, missionOf } from "../../model/testing/missions";
import type { Program } from "../../model/types";
import type { Drawing } from "../../session/drawing";
import { insideOf, targetInLayout } from "../../session/targets";
import { walk } from "./walk";

const structure = readStructure(CARRIER, PARTS);
const layout = layoutStructure(structure);
const nodes = new Map(layout.nodes.map((node) => [node.id, node]));
const drawing: Drawing = {
  program: CARRIER,
  parts: PARTS,
  structure,
  layout,
  nodes,
  language: "en",
  folded: new Set<string>(),
};

describe("the arrow keys", () => {
  it("go up and down in the order of reading", () => {
    const down: (string | null)[] = ["start"];
    for (let id = down[0] ?? null; id !== null && id !== "stop";) down.push((id = walk(drawing, id, "down")));
    expect(down).toEqual([
      "start",
      "v1",
      "v3",
      "v4",
      "v6",
      "v8",
      "v9",
      "v11",
      "v13",
      "v14",
      "v17",
      "v18",
      "v20",
      "stop",
    ]);
    expect(walk(drawing, "v18", "up")).toBe("v17");
    expect(walk(drawing, "stop", "down")).toBeNull();
  });

  it("begin at Start", () => {
    expect(walk(drawing, null, "down")).toBe("start");
  });

  it("go into a body and out to its owner", () => {
    expect(walk(drawing, "v1", "right")).toBe("v3");
    expect(walk(drawing, "v13", "left")).toBe("v11");
    expect(walk(drawing, "v1", "left")).toBeNull();
  });

  it("go to the branch beside", () => {
    expect(walk(drawing, "v6", "left")).toBe("v4");
    expect(walk(drawing, "v8", "left")).toBe("v4");
    expect(walk(drawing, "v3", "right")).toBe("v4");
  });

  it("come back from a test to the vertex that holds it", () => {
    expect(walk(drawing, "v5", "left")).toBe("v4");
    expect(walk(drawing, "v5", "down")).toBe("v6");
    expect(walk(drawing, "v5", "up")).toBe("v4");
  });
});

describe("the place for something dragged", () => {
  const at = (id: string, dx = 0, dy = 0) => {
    const node = nodes.get(id);
    if (node === undefined) throw new Error(id);
    return { x: node.x + node.w / 2 + dx, y: node.y + node.h / 2 + dy };
  };
  const aim = (element: string, point: { x: number; y: number }, moving: string[] = [], parts = PARTS) =>
    targetInLayout({ ...drawing, parts }, point, 60, parts.shape(element), insideOf(drawing, moving))?.key;

  it("is the nearest arc, before or after a vertex", () => {
    expect(aim("Wheel.Stop", at("v13", 0, -20))).toBe("arc:v11.body");
    expect(aim("Wheel.Stop", at("v13", 0, 25))).toBe("arc:v13.next");
    expect(aim("Wheel.Stop", at("v6", 10, 120))).toBe("arc:v4.next");
  });

  it("is the void far from every arc, and for a value that meets no slot", () => {
    expect(aim("Wheel.Stop", { x: 2000, y: 0 })).toBe("void");
    expect(aim("Run.IsTrue", { x: 2000, y: 0 }, [], WAITING_PARTS)).toBe("void");
    expect(aim("Count.Value", at("v13"))).toBe("void");
  });

  it("is an arc for a new test, which is waited for there, and none for one that moves", () => {
    expect(aim("Run.IsTrue", at("v13", 0, 25), [], WAITING_PARTS)).toBe("arc:v13.next");
    expect(aim("Run.IsTrue", at("v13", 0, 25), ["v5"], WAITING_PARTS)).toBe("void");
    // Where nothing only waits, a test has no place among the arcs.
    expect(aim("Run.IsTrue", at("v13", 0, 25))).toBe("void");
  });

  it("is the arc from Start to Stop for the first part, wherever it is dropped", () => {
    const far = { x: 2000, y: 900 };
    const aimIn = (program: Program, element: string) => {
      const read = readStructure(program, PARTS);
      const shown = layoutStructure(read);
      const all = new Map(shown.nodes.map((node) => [node.id, node]));
      const there = { ...drawing, program, structure: read, layout: shown, nodes: all };
      return targetInLayout(there, far, 60, PARTS.shape(element), new Set())?.place ?? null;
    };
    const empty = emptyProgram("p", "carrier");
    const place = aimIn(empty, "Wheel.Stop");
    expect(place).toEqual({ kind: "arc", source: "start", out: "next" });
    const command = place === null ? null : insertPart(empty, PARTS, place, "Wheel.Stop");
    const [joined = empty] = command?.execute(missionOf(empty)).programs ?? [];
    expect(joined.arcs.map(({ source, target }) => [source, target])).toEqual([
      ["start", "v1"],
      ["v1", "stop"],
    ]);
    expect(aimIn(joined, "Wheel.Stop")).toEqual({ kind: "void" });
    expect(aimIn(empty, "Run.IsTrue")).toEqual({ kind: "void" });
  });

  it("is the innermost parallel for a branch, and none outside", () => {
    expect(aim("Branch", at("v13"))).toBe("vertex:v3");
    expect(aim("Branch", at("v20"))).toBeUndefined();
  });

  it("is the action under it for a mark, unless it is marked already", () => {
    expect(aim("Interrupt", at("v13"))).toBe("vertex:v13");
    expect(aim("Interrupt", at("v8"))).not.toBe("vertex:v8");
  });

  it("is never inside of what moves", () => {
    expect([...insideOf(drawing, ["v14"])]).toEqual(["v14", "v15", "v16", "v17"]);
    expect([...insideOf(drawing, ["v8"])]).toEqual(["v7", "v8"]);
    expect(aim("When", at("v17", 0, 24), ["v14"])).toBe("arc:v11.next");
  });
});
