import { describe, expect, it } from "vitest";

import { emptyProgram } from "./commands/changePrograms";
import { insertPart } from "./commands/insertPart";
import { placeFor } from "./placeFor";
import { readStructure } from "./structure";
import { CARRIER, CARRIER_PARTS as PARTS, missionOf } from "./testing/missions";

const structure = readStructure(CARRIER, PARTS);
const near = (vertex: string | null, element: string, arc: { source: string; out: string } | null = null) =>
  placeFor(structure, { vertex, arc }, PARTS.shape(element));

describe("the place of a part that nobody pointed at", () => {
  it("is after the selected vertex, after the mark of a marked action", () => {
    expect(near("v13", "While")).toEqual({ kind: "arc", source: "v13", out: "next" });
    expect(near("v8", "While")).toEqual({ kind: "arc", source: "v7", out: "next" });
    expect(near("v5", "While")).toEqual({ kind: "arc", source: "v4", out: "next" });
  });

  it("is the selected arc", () => {
    expect(near(null, "While", { source: "v3", out: "branch.1" })).toEqual({
      kind: "arc",
      source: "v3",
      out: "branch.1",
    });
  });

  it("is the end of the program when nothing is selected", () => {
    expect(near(null, "While")).toEqual({ kind: "arc", source: "v1", out: "next" });
    const empty = readStructure(emptyProgram("p", "carrier"), PARTS);
    const place = placeFor(empty, { vertex: null, arc: null }, PARTS.shape("While"));
    expect(place).toEqual({ kind: "arc", source: "start", out: "next" });
  });

  it("is the first empty slot for a test", () => {
    const command = insertPart(CARRIER, PARTS, { kind: "arc", source: "v1", out: "next" }, "When");
    const program = command?.execute(missionOf(CARRIER)).programs[0] ?? CARRIER;
    const place = placeFor(readStructure(program, PARTS), { vertex: null, arc: null }, PARTS.shape("Run.IsTrue"));
    expect(place).toEqual({ kind: "slot", vertex: "v21", slot: "condition" });
  });

  it("is the slot of the selected test or vertex when it is full", () => {
    expect(near("v5", "And")).toEqual({ kind: "slot", vertex: "v4", slot: "condition" });
    expect(near("v4", "Cargo.IsPressed")).toEqual({ kind: "slot", vertex: "v4", slot: "condition" });
    expect(near("v8", "Count.Value")).toEqual({ kind: "slot", vertex: "v8", slot: "speed" });
  });

  it("is the void for a test that fits nowhere", () => {
    expect(near("v13", "Cargo.IsPressed")).toEqual({ kind: "void" });
  });

  it("is behind the selection, or on the selected arc, for a test that may be waited for", () => {
    const structure = readStructure(CARRIER, PARTS);
    const wait = (vertex: string | null, arc: { source: string; out: string } | null, element: string) =>
      placeFor(structure, { vertex, arc }, PARTS.shape(element), true);
    expect(wait("v13", null, "Cargo.IsPressed")).toEqual({ kind: "arc", source: "v13", out: "next" });
    expect(wait(null, { source: "v11", out: "body" }, "Run.IsTrue")).toEqual({
      kind: "arc",
      source: "v11",
      out: "body",
    });
    // A slot that fits it comes first; with nothing selected it lies beside the program.
    expect(wait("v4", null, "Cargo.IsPressed")).toEqual({ kind: "slot", vertex: "v4", slot: "condition" });
    expect(wait(null, null, "Cargo.IsPressed")).toEqual({ kind: "void" });
  });

  it("is the parallel around the selection for a branch, or nothing", () => {
    expect(near("v6", "Branch")).toEqual({ kind: "vertex", vertex: "v3" });
    expect(near(null, "Branch")).toEqual({ kind: "vertex", vertex: "v3" });
    expect(near("v20", "Branch")).toBeNull();
  });

  it("is the selected action for a mark", () => {
    expect(near("v13", "Interrupt")).toEqual({ kind: "vertex", vertex: "v13" });
    expect(near("v8", "Interrupt")).toEqual({ kind: "arc", source: "v7", out: "next" });
  });
});
