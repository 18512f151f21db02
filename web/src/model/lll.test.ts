import { describe, expect, it } from "vitest";

import type { Command } from "./command";
import { emptyProgram } from "./commands/changePrograms";
import { insertPart } from "./commands/insertPart";
import { pasteParts } from "./commands/pasteParts";
import { setNote } from "./commands/setNote";
import { stretchOf, unwrapPart, wrapParts } from "./commands/wrapParts";
import { blocksOf, copyOf, readPiece } from "./fragment";
import { lllOf } from "./lll";
import { readStructure } from "./structure";
import { CARRIER, CARRIER_PARTS as PARTS, growProgram, missionOf } from "./testing/missions";
import type { Program } from "./types";

function after(program: Program, command: Command | null): Program {
  const changed = command?.execute(missionOf(program)).programs[0];
  if (changed === undefined) throw new Error("no command");
  return changed;
}

const carrier = readStructure(CARRIER, PARTS);
const copied = (program: Program, ...ids: string[]) => copyOf(readStructure(program, PARTS), ids);

describe("blocks as text", () => {
  it("are their templates, filled, a line an instruction", () => {
    expect(lllOf(carrier.main.chain.flatMap((block) => block.bodies[0]?.chain.slice(1) ?? []))).toBe(
      "<Cargo.IsPressed()>(\n  Lamp.LightOff();\n);\n",
    );
  });

  it("have a comma between branches and marks around actions", () => {
    const text = copied(CARRIER, "v3")?.lll ?? "";
    expect(text).toContain("//(\n  <Sign.EqualTo(0)>(\n    Lamp.LightOn();\n  );\n  ,\n  °Wheel.Advance(50)°;\n");
  });

  it("carry notes as comments", () => {
    const noted = after(CARRIER, setNote(CARRIER, "v18", "why\nnot"));
    expect(copied(noted, "v18")?.lll).toMatch(/^# why\n# not\n</);
  });

  it("of a condition alone end without a semicolon", () => {
    expect(copied(CARRIER, "v5")?.lll).toBe("Sign.EqualTo(0)\n");
  });
});

describe("a piece", () => {
  it("is what is selected with all it holds, topmost only", () => {
    const piece = copied(CARRIER, "v11", "v13", "v18")?.program;
    expect(blocksOf(piece ?? CARRIER, PARTS).map((block) => block.vertex.element)).toEqual(["When", "When"]);
    expect(piece?.vertices.map((one) => one.id)).toContain("v17");
  });

  it("of nothing, or of Start, is none", () => {
    expect(copied(CARRIER)).toBeNull();
    expect(copied(CARRIER, "start")).toBeNull();
  });

  it("pastes with ids of its own, as often as one likes", () => {
    const piece = copied(CARRIER, "v18")?.program ?? CARRIER;
    const place = { kind: "arc", source: "v18", out: "next" } as const;
    const once = after(CARRIER, pasteParts(CARRIER, PARTS, place, piece));
    const twice = after(once, pasteParts(once, PARTS, place, piece));
    expect(twice.vertices.length).toBe(CARRIER.vertices.length + 6);
    expect(new Set(twice.vertices.map((one) => one.id)).size).toBe(twice.vertices.length);
    expect(readStructure(twice, PARTS).strays).toEqual([]);
  });

  it("that is a condition docks on a slot and cannot stand on an arc", () => {
    const piece = copied(CARRIER, "v5")?.program ?? CARRIER;
    const slot = { kind: "slot", vertex: "v18", slot: "condition" } as const;
    expect(after(CARRIER, pasteParts(CARRIER, PARTS, slot, piece)).arcs).toContainEqual(
      expect.objectContaining({ target: "v18", at: "condition" }),
    );
    expect(pasteParts(CARRIER, PARTS, { kind: "arc", source: "v18", out: "next" }, piece)).toBeNull();
  });

  it.each(["", "{}", "[]", "null", '{"name":"a","robot":"b","vertices":[{}],"arcs":[]}', "not json"])(
    "is not read from %j",
    (text) => {
      expect(readPiece(text)).toBeNull();
    },
  );

  it("comes back from its JSON as it was, for programs of every part", () => {
    for (let seed = 1; seed <= 10; seed++) {
      const program = growProgram(seed, 30, true);
      const piece = copied(program, ...program.vertices.map((one) => one.id))?.program;
      expect(readPiece(JSON.stringify(piece))).toEqual(piece);
    }
  });
});

describe("wrapping", () => {
  it("encloses the stretch from the first to the last selected vertex", () => {
    const program = after(CARRIER, wrapParts(CARRIER, PARTS, ["v18", "v3"], "While"));
    const [outer] = readStructure(program, PARTS).main.chain;
    expect(outer?.bodies[0]?.chain.map((one) => one.vertex.element)).toEqual(["While"]);
    expect(outer?.bodies[0]?.chain[0]?.bodies[0]?.chain.map((one) => one.vertex.id)).toEqual(["v3", "v18"]);
  });

  it("puts the stretch into the first branch of what has several", () => {
    const program = after(CARRIER, wrapParts(CARRIER, PARTS, ["v18"], "Parallelism"));
    const added = program.vertices.find((one) => one.id === "v21");
    expect(added?.element).toBe("Parallelism");
    expect(program.arcs).toContainEqual({ source: "v21", target: "v18", out: "branch.1", at: "in" });
  });

  it("takes a marked action with its mark", () => {
    const program = after(CARRIER, wrapParts(CARRIER, PARTS, ["v8"], "While"));
    expect(program.arcs).toContainEqual({ source: "v21", target: "v7", out: "body", at: "in" });
  });

  it("of vertices in several chains, or in what holds no chain, is not possible", () => {
    expect(wrapParts(CARRIER, PARTS, ["v6", "v18"], "While")).toBeNull();
    expect(wrapParts(CARRIER, PARTS, ["v18"], "Wait")).toBeNull();
    expect(wrapParts(CARRIER, PARTS, ["v18"], "And")).toBeNull();
    expect(wrapParts(CARRIER, PARTS, ["start"], "While")).toBeNull();
    expect(stretchOf(carrier, [])).toBeNull();
  });

  it("is taken back by unwrapping", () => {
    const wrapped = after(CARRIER, wrapParts(CARRIER, PARTS, ["v3", "v18"], "While"));
    expect(after(wrapped, unwrapPart(wrapped, PARTS, "v21")).arcs).toEqual(CARRIER.arcs);
  });

  it("unwrapped from several branches leaves them one after the other", () => {
    const program = after(CARRIER, unwrapPart(CARRIER, PARTS, "v3"));
    const chain = readStructure(program, PARTS).main.chain[0]?.bodies[0]?.chain;
    expect(chain?.map((one) => one.vertex.id)).toEqual(["v4", "v7", "v9", "v18"]);
  });

  it("unwrapped keeps the note on what comes first", () => {
    const noted = after(CARRIER, setNote(CARRIER, "v18", "why"));
    const program = after(noted, unwrapPart(noted, PARTS, "v18"));
    expect(program.vertices.find((one) => one.id === "v20")?.notes).toEqual([{ text: "why", at: "" }]);
  });

  it("unwraps nothing that holds nothing, and an empty loop is simply gone", () => {
    expect(unwrapPart(CARRIER, PARTS, "v6")).toBeNull();
    expect(unwrapPart(CARRIER, PARTS, "start")).toBeNull();
    const empty = emptyProgram("p", "carrier");
    const one = after(empty, insertPart(empty, PARTS, { kind: "arc", source: "start", out: "next" }, "While"));
    expect(after(one, unwrapPart(one, PARTS, "v1")).arcs).toEqual(empty.arcs);
  });
});
