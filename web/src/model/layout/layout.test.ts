import { describe, expect, it } from "vitest";

import { emptyProgram } from "../commands/changePrograms";
import { insertPart } from "../commands/insertPart";
import { type Block, readStructure, type Structure } from "../structure";
import { CARRIER, CARRIER_PARTS as PARTS, growProgram, missionOf } from "../testing/missions";
import type { Place } from "../tree";
import type { Program } from "../types";
import { type Layout, type LayoutArc, type LayoutNode, layoutStructure } from ".";

const layout = (program: Program) => layoutStructure(readStructure(program, PARTS));

function node(of: Layout, id: string): LayoutNode {
  const found = of.nodes.find((one) => one.id === id);
  if (found === undefined) throw new Error(`no node ${id}`);
  return found;
}

function arc(of: Layout, id: string): LayoutArc {
  const found = of.arcs.find((one) => one.id === id);
  if (found === undefined) throw new Error(`no arc ${id}`);
  return found;
}

const middle = ({ y, h }: LayoutNode) => y + h / 2;

describe("the carrier of the picture", () => {
  const drawn = layout(CARRIER);

  it("has its rows where the picture has them", () => {
    const rows = [
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
      "v3:end",
      "v18",
      "v20",
      "stop",
    ];
    expect(rows.map((id) => middle(node(drawn, id)) + 40)).toEqual([
      40, 104, 152, 200, 264, 200, 264, 328, 392, 456, 520, 592, 640, 704, 800,
    ]);
  });

  it("has its columns where the picture has them", () => {
    const columns = ["v1", "v4", "v8", "v9"].map((id) => node(drawn, id).x + node(drawn, id).w / 2 + 456);
    expect(columns).toEqual([456, 240, 616, 616]);
  });

  it("draws vertices in the picture's widths", () => {
    expect(["v1", "v4", "v6", "v8", "v11", "v3"].map((id) => node(drawn, id).w)).toEqual([
      256, 280, 256, 288, 296, 752,
    ]);
  });

  it("draws loops as their own frames and choices as legend boxes", () => {
    const frames = drawn.frames.map(({ id, kind, x, y, w, h }) => [id, kind, x + 456, y + 40, w, h]);
    expect(frames).toEqual([
      ["v1", "loop", 56, 104, 800, 640],
      ["v3", "parallel", 80, 152, 752, 440],
      ["v4", "legend", 88, 200, 304, 94],
      ["v9", "loop", 416, 264, 400, 304],
      ["v11", "legend", 440, 328, 352, 230],
      ["v14", "legend", 456, 456, 320, 94],
      ["v18", "legend", 304, 640, 304, 94],
    ]);
  });

  it("shows a marked action as one vertex, its arcs by the mark's name", () => {
    expect(node(drawn, "v8").mark?.vertex.id).toBe("v7");
    expect(drawn.nodes.some((one) => one.id === "v7")).toBe(false);
    expect(arc(drawn, "v7.next").points).toEqual([
      { x: 160, y: 182 },
      { x: 160, y: 202 },
    ]);
  });

  it("returns on the left edge and leaves by the right one, straight into the bar at the end of a branch", () => {
    expect(arc(drawn, "v18.next")).toMatchObject({ colour: "loop", head: true });
    expect(arc(drawn, "v18.next").points.at(-1)).toEqual({ x: -128, y: 64 });
    expect(arc(drawn, "v9.next").points).toEqual([
      { x: 288, y: 224 },
      { x: 360, y: 224 },
      { x: 360, y: 548 },
    ]);
    expect(arc(drawn, "v1.next").points.at(-1)).toEqual({ x: 0, y: 738 });
  });

  it("colours an arc by who owns it", () => {
    const colours = ["start.next", "v1.body", "v3.branch.1", "v4.body", "v6.next", "v4.next", "v13.next", "v3.next"];
    expect(colours.map((id) => arc(drawn, id).colour)).toEqual([
      "flow",
      "loop",
      "parallel",
      "choice",
      "parallel",
      "parallel",
      "flow",
      "parallel",
    ]);
  });

  it("draws every arc of the file between vertices", () => {
    const flow = CARRIER.arcs.filter((one) => one.at === "in" || one.at === "return");
    expect(new Set(drawn.arcs.map((one) => one.id))).toEqual(new Set(flow.map((one) => `${one.source}.${one.out}`)));
  });
});

describe("other programs", () => {
  it("shows the place for the first part in an empty one", () => {
    const drawn = layout(emptyProgram("p", "carrier"));
    expect(drawn.nodes.map((one) => [one.id, middle(one)])).toEqual([
      ["start", 0],
      ["place", 104],
      ["stop", 200],
    ]);
  });

  it("gives an empty body an arc one can drop on", () => {
    const program = growFrom("While");
    const place = layout(program).nodes.find((node) => node.id === "v1.body");
    expect(place).toMatchObject({ kind: "place", w: 304, h: 48 });
    expect(arc(layout(program), "v1.body").label?.text).toBe("do");
  });

  it("sets the columns of a choice apart and lets them meet again", () => {
    const drawn = layout(growFrom("If Then Else"));
    const [yes, no] = [arc(drawn, "v1.then"), arc(drawn, "v1.else")];
    expect([yes.label?.text, no.label?.text]).toEqual(["yes", "no"]);
    expect(yes.points.at(-1)).toEqual(no.points.at(-1));
    expect(arc(drawn, "v1.next").points[0]).toEqual(yes.points.at(-1));
  });

  it("draws a body that does not return as far as it goes", () => {
    const arcs = CARRIER.arcs.filter((one) => one.source !== "v6");
    const drawn = layout({ ...CARRIER, arcs });
    expect(arc(drawn, "v6.next").missing).toBe(true);
  });

  it("keeps parked chains beside the program, each in a frame", () => {
    const drawn = layout(growProgram(3, 40, true));
    const right = Math.max(...drawn.nodes.filter((one) => !one.parked).map((one) => one.x + one.w));
    const parked = drawn.nodes.filter((one) => one.parked);
    expect(parked.length).toBeGreaterThan(0);
    for (const one of parked) expect(one.x).toBeGreaterThan(right);
  });

  it("survives programs without ends", () => {
    const lonely: Program = { name: "p", robot: "carrier", vertices: [], arcs: [] };
    expect(layout(lonely).nodes).toEqual([]);
    const start = { ...emptyProgram("p", "carrier"), arcs: [] };
    expect(arc(layout(start), "start.next").missing).toBe(true);
  });
});

/** Puts parts one into the other: "If Then Else.then" is a body. */
function built(...steps: [place: Place, element: string][]): Program {
  return steps.reduce(
    (program, [place, element]) => {
      const command = insertPart(program, PARTS, place, element);
      return command?.execute(missionOf(program)).programs[0] ?? program;
    },
    emptyProgram("p", "carrier"),
  );
}
const at = (source: string, out: string): Place => ({ kind: "arc", source, out });

describe("a loop without a test", () => {
  const FOREVER = {
    ...PARTS,
    shape: (element: string) => ({
      ...PARTS.shape(element),
      ...(element === "While" ? { plugs: [], fields: [] } : {}),
    }),
  };
  const leaving = (program: Program, parts = FOREVER) =>
    arc(layoutStructure(readStructure(program, parts)), "v1.next").label?.text;

  it("is done only where a Break in it ends it", () => {
    const endless = built([at("start", "next"), "While"], [at("v1", "body"), "Wait"]);
    expect(leaving(endless)).toBeUndefined();
    expect(leaving(endless, PARTS)).toBe("done");
    expect(leaving(built([at("start", "next"), "While"], [at("v1", "body"), "Break"]))).toBe("done");
    // One in a loop inside ends that one alone.
    const inner = built([at("start", "next"), "While"], [at("v1", "body"), "While"], [at("v2", "body"), "Break"]);
    expect(leaving(inner)).toBeUndefined();
  });
});

describe("a Break", () => {
  const only = (of: Layout) => {
    expect(of.leaps).toHaveLength(1);
    return of.leaps[0]?.points ?? [];
  };

  it("leads straight to the right edge of its loop, where the exit is", () => {
    const drawn = layout(
      built([at("start", "next"), "While"], [at("v1", "body"), "If Then"], [at("v2", "then"), "Break"]),
    );
    const frame = drawn.frames.find((one) => one.id === "v1");
    const own = node(drawn, "v3");
    expect(only(drawn)).toEqual([
      { x: own.x + own.w, y: middle(own) },
      { x: (frame?.x ?? 0) + (frame?.w ?? 0), y: middle(own) },
    ]);
    expect(drawn.leaps[0]).toMatchObject({ colour: "loop", label: { text: "out" } });
  });

  it("goes down beside its column and under the others, and comes out of the innermost loop", () => {
    const drawn = layout(
      built(
        [at("start", "next"), "While"],
        [at("v1", "body"), "If Then Else"],
        [at("v2", "then"), "Break"],
        [at("v2", "else"), "Lamp.LightOn"],
        [at("v4", "next"), "Lamp.LightOff"],
      ),
    );
    const points = only(drawn);
    expect(points).toHaveLength(4);
    const deepest = node(drawn, "v5");
    expect(points[2]?.y).toBeGreaterThan(deepest.y + deepest.h);
    const frame = drawn.frames.find((one) => one.id === "v1");
    expect(points[3]?.x).toBe((frame?.x ?? 0) + (frame?.w ?? 0));
    expect(points[3]?.y).toBeLessThan((frame?.y ?? 0) + (frame?.h ?? 0));
  });

  it("ends its branch where there is no loop in it, for it never leaves a parallel", () => {
    const drawn = layout(
      built(
        [at("start", "next"), "While"],
        [at("v1", "body"), "Parallelism"],
        [at("v2", "branch.1"), "Break"],
        [at("v2", "branch.2"), "Lamp.LightOn"],
      ),
    );
    const bar = node(drawn, "v2:end");
    expect(only(drawn).at(-1)?.y).toBe(bar.y + 10);
    expect(only(drawn).at(-1)?.x).toBeLessThan(bar.x + bar.w);
  });

  it("ends the program where there is no loop at all", () => {
    const drawn = layout(built([at("start", "next"), "Break"], [at("v1", "next"), "Wait"]));
    const stop = node(drawn, "stop");
    expect(only(drawn).at(-1)).toEqual({ x: stop.x + stop.w, y: middle(stop) });
  });

  it("leads nowhere on a parked chain", () => {
    expect(layout(built([{ kind: "void" }, "Break"])).leaps).toEqual([]);
  });

  it("never goes on: its own arc is drawn as never taken, and those after it are not", () => {
    const drawn = layout(built([at("start", "next"), "While"], [at("v1", "body"), "Break"]));
    expect(arc(drawn, "v2.next").dead).toBe(true);
    expect(arc(drawn, "v1.next").dead).toBe(false);
  });
});

function growFrom(element: string): Program {
  const empty = emptyProgram("p", "carrier");
  const flows = PARTS.shape(element).flows.map((flow) => flow.name);
  return {
    ...empty,
    vertices: [
      ...empty.vertices.slice(0, 1),
      { id: "v1", element, settings: {}, notes: [] },
      ...empty.vertices.slice(1),
    ],
    arcs: [
      { source: "start", target: "v1", out: "next", at: "in" },
      ...flows.map((out) => ({ source: "v1", target: "v1", out, at: "return" })),
      { source: "v1", target: "stop", out: "next", at: "in" },
    ],
  };
}

interface Box {
  x: number;
  y: number;
  w: number;
  h: number;
}

const overlap = (a: Box, b: Box) => a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;
const inside = (a: Box, b: Box) => a.x >= b.x && a.y >= b.y - 22 && a.x + a.w <= b.x + b.w && a.y + a.h <= b.y + b.h;

/** A line as boxes without a breadth. */
function pieces(points: { x: number; y: number }[]): Box[] {
  return points.slice(1).map((b, index) => {
    const a = points[index] ?? b;
    if (a.x !== b.x && a.y !== b.y) throw new Error("a line is slanted");
    return { x: Math.min(a.x, b.x), y: Math.min(a.y, b.y), w: Math.abs(a.x - b.x), h: Math.abs(a.y - b.y) };
  });
}

/** Every pair (block, block directly in one of its bodies). */
function pairs(structure: Structure): [Block, Block][] {
  const all: [Block, Block][] = [];
  const down = (owner: Block | null, chain: Block[]) => {
    for (const one of chain) {
      if (owner !== null) all.push([owner, one]);
      for (const body of one.bodies) down(one, body.chain);
    }
  };
  down(null, structure.main.chain);
  for (const chain of structure.parked) down(null, chain);
  return all;
}

describe("random programs", () => {
  for (let seed = 1; seed <= 30; seed++) {
    it(`overlap nowhere and stay in their frames (seed ${String(seed)})`, () => {
      const structure = readStructure(growProgram(seed, 60, true), PARTS);
      const drawn = layoutStructure(structure);
      const vertices = drawn.nodes.filter((one) => one.kind !== "barEnd" && one.kind !== "bar");
      vertices.forEach((a, index) => {
        for (const b of vertices.slice(index + 1)) expect(overlap(a, b), `${a.id} on ${b.id}`).toBe(false);
      });
      const frames = new Map(drawn.frames.filter((one) => one.kind !== "parked").map((one) => [one.id, one]));
      for (const [owner, child] of pairs(structure)) {
        const frame = frames.get(owner.vertex.id);
        const shown = drawn.nodes.find((one) => one.id === child.vertex.id || one.mark?.vertex.id === child.vertex.id);
        if (frame === undefined || shown === undefined) throw new Error(`nothing drawn for ${child.vertex.id}`);
        expect(inside(shown, frame), `${shown.id} in ${owner.vertex.id}`).toBe(true);
        const inner = frames.get(child.vertex.id);
        if (inner !== undefined) expect(inside(inner, frame), `${child.vertex.id} in ${owner.vertex.id}`).toBe(true);
      }
      for (const one of drawn.arcs) {
        one.points.slice(1).forEach((point, index) => {
          const before = one.points[index];
          expect(before?.x === point.x || before?.y === point.y, `${one.id} is slanted`).toBe(true);
        });
        if (one.head) expect(one.points.length).toBeGreaterThan(1);
      }
      for (const leap of drawn.leaps) {
        for (const box of vertices) {
          if (box.id === leap.source) continue;
          for (const piece of pieces(leap.points))
            expect(overlap(piece, box), `${leap.source} over ${box.id}`).toBe(false);
        }
      }
    });
  }

  it("of 5 000 vertices are laid out one under the other", () => {
    const chain = Array.from({ length: 230 }, () => CARRIER).map((program, copy) => ({
      vertices: program.vertices.slice(1, -1).map((one) => ({ ...one, id: `${one.id}-${String(copy)}` })),
      arcs: program.arcs
        .filter((one) => one.source !== "start" && one.target !== "stop")
        .map((one) => ({ ...one, source: `${one.source}-${String(copy)}`, target: `${one.target}-${String(copy)}` })),
    }));
    const empty = emptyProgram("big", "carrier");
    const joints = ["start", ...chain.map((_, copy) => `v1-${String(copy)}`), "stop"];
    const big: Program = {
      ...empty,
      vertices: [...empty.vertices.slice(0, 1), ...chain.flatMap((one) => one.vertices), ...empty.vertices.slice(1)],
      arcs: [
        ...joints.slice(1).map((target, at) => ({ source: joints[at] ?? "", target, out: "next", at: "in" })),
        ...chain.flatMap((one) => one.arcs),
      ],
    };
    expect(big.vertices.length).toBeGreaterThan(4500);
    const drawn = layout(big);
    const copies = drawn.nodes.filter((one) => one.vertex.startsWith("v1-"));
    expect(copies).toHaveLength(230);
    expect(copies.every((one, at) => at === 0 || one.y > (copies[at - 1]?.y ?? 0))).toBe(true);
  });
});

describe("a program that was laid out before", () => {
  /** The same program of which nothing is known: all its objects are new. */
  const fresh = (program: Program) => JSON.parse(JSON.stringify(program)) as Program;

  it.each([1, 2, 3, 4, 5, 6])("is laid out after an edit as if it never had been (seed %d)", (seed) => {
    const program = growProgram(seed, 30, true);
    layout(program);
    program.vertices.forEach((vertex, at) => {
      const settings = Object.fromEntries(Object.keys(vertex.settings).map((name) => [name, "12345"]));
      const vertices = program.vertices.map((one, place) => (place === at ? { ...one, settings } : one));
      // What fills a slot goes out of it, and into others.
      const arcs = program.arcs.filter((one) => one.source !== vertex.id || one.at === "in" || one.at === "return");
      for (const edited of [
        { ...program, vertices },
        { ...program, arcs },
      ])
        expect(layout(edited)).toEqual(layout(fresh(edited)));
    });
  });

  it("shows a condition in the slot that it was moved to", () => {
    const vertices = ["Start", "If", "And", "Whisker.IsPressed", "Stop"].map((element, at) => ({
      ...(CARRIER.vertices[0] as Program["vertices"][number]),
      id: `n${String(at)}`,
      element,
      settings: {},
      notes: [],
    }));
    const into = (at: string): Program => ({
      ...CARRIER,
      vertices,
      arcs: [
        { source: "n0", target: "n1", out: "next", at: "in" },
        { source: "n2", target: "n1", out: "next", at: "condition" },
        { source: "n3", target: "n2", out: "next", at },
        { source: "n1", target: "n4", out: "next", at: "in" },
      ],
    });
    const [left, right] = [into("left"), into("right")];
    layout(left);
    expect(layout(right)).toEqual(layout(fresh(right)));
  });
});
