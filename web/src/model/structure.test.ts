import { describe, expect, it } from "vitest";

import { readStructure, writeStructure } from "./structure";
import { CARRIER, CARRIER_PARTS, growProgram } from "./testing/missions";
import type { Program } from "./types";

const through = (program: Program) => writeStructure(readStructure(program, CARRIER_PARTS));

describe("structure", () => {
  it("reads bodies, branches and conditions off the arcs", () => {
    const { main, strays, parked } = readStructure(CARRIER, CARRIER_PARTS);
    expect(strays).toEqual([]);
    expect(parked).toEqual([]);
    expect(main.closed).toBe(true);
    const [loop] = main.chain;
    expect(loop?.plugs[0]?.block?.vertex.id).toBe("v2");
    const [both, when] = loop?.bodies[0]?.chain ?? [];
    expect(both?.bodies.map((body) => [body.out, body.closed, body.chain.length])).toEqual([
      ["branch.1", true, 1],
      ["branch.2", true, 2],
    ]);
    expect(when?.bodies[0]?.chain[0]?.vertex.element).toBe("Lamp.LightOff");
  });

  it("writes back what it read, word for word", () => {
    expect(through(CARRIER)).toEqual(CARRIER);
  });

  it("keeps the vertices and arcs that stayed: the very objects", () => {
    const again = through(CARRIER);
    expect(again.vertices.every((one, at) => one === CARRIER.vertices[at])).toBe(true);
    expect(again.arcs.every((one, at) => one === CARRIER.arcs[at])).toBe(true);
  });

  it("keeps what a program is besides its graph", () => {
    const program: Program = { ...CARRIER, robot: "", level: "social" };
    expect(through(program)).toEqual(program);
  });

  it("writes back random programs, parked parts too", () => {
    for (let seed = 1; seed <= 60; seed++) {
      const program = growProgram(seed, 30, true);
      expect(through(program)).toEqual(program);
      expect(readStructure(program, CARRIER_PARTS).strays).toEqual([]);
    }
  });

  it("keeps an arc into another body as a stray", () => {
    const stray = { source: "v6", target: "v13", out: "next", at: "in" };
    const broken = { ...CARRIER, arcs: [...CARRIER.arcs, stray] };
    expect(readStructure(broken, CARRIER_PARTS).strays).toEqual([stray]);
    expect(through(broken).arcs).toEqual(broken.arcs);
  });

  it("reads the rest of a program in which a body does not return", () => {
    const arcs = CARRIER.arcs.filter((arc) => !(arc.source === "v6" && arc.at === "return"));
    const { main } = readStructure({ ...CARRIER, arcs }, CARRIER_PARTS);
    const when = main.chain[0]?.bodies[0]?.chain[0]?.bodies[0]?.chain[0];
    expect(when?.bodies[0]?.closed).toBe(false);
    expect(through({ ...CARRIER, arcs }).arcs).toEqual(arcs);
  });

  it("reads an element without XML by its arcs", () => {
    const vertices = CARRIER.vertices.map((one) => (one.id === "v1" ? { ...one, element: "Spiral" } : one));
    const program = { ...CARRIER, vertices };
    const [spiral] = readStructure(program, CARRIER_PARTS).main.chain;
    expect(spiral?.shape.kind).toBe("unknown");
    expect(spiral?.bodies[0]?.chain.length).toBe(2);
    expect(spiral?.plugs[0]?.block?.vertex.id).toBe("v2");
    expect(through(program)).toEqual(program);
  });

  it("loses no vertex of a ring, a doubled id or a missing end", () => {
    const vertices = [
      { id: "start", element: "Start", settings: {}, notes: [] },
      { id: "a", element: "Lamp.LightOn", settings: {}, notes: [] },
      { id: "b", element: "Lamp.LightOff", settings: {}, notes: [] },
      { id: "b", element: "Wheel.Stop", settings: {}, notes: [] },
    ];
    const arcs = [
      { source: "a", target: "b", out: "next", at: "in" },
      { source: "b", target: "a", out: "next", at: "in" },
      { source: "start", target: "nowhere", out: "next", at: "in" },
    ];
    const after = through({ name: "p", robot: "carrier", vertices, arcs });
    expect(after.vertices.length).toBe(4);
    expect(new Set(after.arcs)).toEqual(new Set(arcs));
  });
});
