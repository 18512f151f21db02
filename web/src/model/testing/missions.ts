/** Missions for tests, and programs grown at random from a seed. */
import { emptyProgram } from "../commands/changePrograms";
import { insertPart } from "../commands/insertPart";
import { type Parts, partsOf } from "../parts";
import { readStructure } from "../structure";
import { everySpot, type Place } from "../tree";
import type { Arc, Mission, MissionFile, Program, Vertex } from "../types";
import { PARTS } from "./parts";

export const CARRIER_PARTS: Parts = partsOf(PARTS, "carrier");

/** The same with `Wait Until`, a constructor that holds nothing but a condition. */
export const WAITING_PARTS: Parts = partsOf(
  {
    ...PARTS,
    groups: PARTS.groups.map((group) => ({
      ...group,
      constructors: group.constructors.flatMap((one) =>
        one.name === "When"
          ? [
              one,
              {
                ...one,
                name: "Wait Until",
                slots: one.slots.filter(({ kind }) => kind === "condition"),
                code: "<{condition}>()",
              },
            ]
          : [one],
      ),
    })),
  },
  "carrier",
);

function vertex(id: string, element: string, settings: Record<string, string> = {}): Vertex {
  return { id, element, settings, notes: [] };
}

function arc(from: string, to: string): Arc {
  const [source = "", out = "next"] = from.split(".");
  const [target = "", at = "in"] = to.split(".");
  return { source, target, out: from.includes(".") ? from.slice(source.length + 1) : out, at };
}

/** The carrier of the picture: drives the ring, stops for collisions and at dock 0. */
export const CARRIER: Program = {
  name: "carrier",
  robot: "carrier",
  vertices: [
    vertex("start", "Start"),
    vertex("v1", "While"),
    vertex("v2", "Run.IsTrue"),
    vertex("v3", "Parallelism"),
    vertex("v4", "When"),
    vertex("v5", "Sign.EqualTo", { value: "0" }),
    vertex("v6", "Lamp.LightOn"),
    vertex("v7", "Interrupt"),
    vertex("v8", "Wheel.Advance", { speed: "50" }),
    vertex("v9", "While"),
    vertex("v10", "Run.IsTrue"),
    vertex("v11", "When"),
    vertex("v12", "Collision.IsPressed"),
    vertex("v13", "Wheel.Stop"),
    vertex("v14", "When"),
    vertex("v15", "Collision.IsReleased"),
    vertex("v16", "Interrupt"),
    vertex("v17", "Wheel.Advance", { speed: "50" }),
    vertex("v18", "When"),
    vertex("v19", "Cargo.IsPressed"),
    vertex("v20", "Lamp.LightOff"),
    vertex("stop", "Stop"),
  ],
  arcs: [
    arc("start", "v1"),
    arc("v2", "v1.condition"),
    arc("v1.body", "v3"),
    arc("v3.branch.1", "v4"),
    arc("v5", "v4.condition"),
    arc("v4.body", "v6"),
    arc("v6", "v4.return"),
    arc("v4", "v3.return"),
    arc("v3.branch.2", "v7"),
    arc("v8", "v7.action"),
    arc("v7", "v9"),
    arc("v10", "v9.condition"),
    arc("v9.body", "v11"),
    arc("v12", "v11.condition"),
    arc("v11.body", "v13"),
    arc("v13", "v14"),
    arc("v15", "v14.condition"),
    arc("v14.body", "v16"),
    arc("v17", "v16.action"),
    arc("v16", "v14.return"),
    arc("v14", "v11.return"),
    arc("v11", "v9.return"),
    arc("v9", "v3.return"),
    arc("v3", "v18"),
    arc("v19", "v18.condition"),
    arc("v18.body", "v20"),
    arc("v20", "v18.return"),
    arc("v18", "v1.return"),
    arc("v1", "stop"),
  ],
};

/** A mission with these programs, one agent each. */
export function missionOf(...programs: Program[]): Mission {
  const agents = programs.map(({ name }) => ({ name: `${name}-1`, program: name, start: "" }));
  return { version: 1, programs, agents, goals: [], world: "" };
}

export function fileOf(mission: Mission): MissionFile {
  return { path: "test.krt", name: "test.krt", revision: "1", mission, problems: [], world: null, catalogue: PARTS };
}

/** Numbers in 0…1 that are the same for the same seed. */
export function randomFrom(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}

export function pick<T>(random: () => number, from: readonly T[]): T {
  const found = from[Math.floor(random() * from.length)];
  if (found === undefined) throw new Error("nothing to pick from");
  return found;
}

/** Every place of the program where something could be dropped. */
export function placesOf(program: Program, parts: Parts = CARRIER_PARTS): Place[] {
  const structure = readStructure(program, parts);
  const places: Place[] = [{ kind: "void" }, { kind: "arc", source: "start", out: "next" }];
  everySpot(structure, ({ kind, block }) => {
    const { id } = block.vertex;
    places.push({ kind: "vertex", vertex: id });
    for (const plug of block.shape.plugs) places.push({ kind: "slot", vertex: id, slot: plug.name });
    for (const body of block.bodies) places.push({ kind: "arc", source: id, out: body.out });
    if (kind === "chain") places.push({ kind: "arc", source: id, out: "next" });
  });
  return places;
}

/** A program of about that many vertices, of every kind of part, the same for the same seed. */
export function growProgram(seed: number, size: number, parked = false): Program {
  const random = randomFrom(seed);
  let program = emptyProgram("grown", "carrier");
  for (let tries = 0; program.vertices.length < size && tries < size * 20; tries++) {
    const aside = parked && random() < 0.08;
    const place: Place = aside ? { kind: "void" } : pick(random, placesOf(program));
    if (place.kind === "void" && !aside) continue;
    const command = insertPart(program, CARRIER_PARTS, place, pick(random, CARRIER_PARTS.all).element);
    program = command?.execute(missionOf(program)).programs[0] ?? program;
  }
  return program;
}
