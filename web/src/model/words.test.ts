import { describe, expect, it } from "vitest";

import { insertPart } from "./commands/insertPart";
import { readStructure } from "./structure";
import { CARRIER, CARRIER_PARTS as PARTS, missionOf } from "./testing/missions";
import { findSpot, type Place } from "./tree";
import type { Program } from "./types";
import { fieldWords, piecesOf, wordsOf } from "./words";

function put(program: Program, vertex: string, slot: string, element: string): Program {
  const place: Place = { kind: "slot", vertex, slot };
  const command = insertPart(program, PARTS, place, element);
  return command?.execute(missionOf(program)).programs[0] ?? program;
}

function block(program: Program, id: string) {
  const spot = findSpot(readStructure(program, PARTS), id);
  if (spot === undefined) throw new Error(`no ${id}`);
  return spot.block;
}

describe("a condition in words", () => {
  it("is its method's phrase with the numbers in it", () => {
    expect(wordsOf(block(CARRIER, "v5"))).toBe("Sign = 0");
    expect(wordsOf(block(CARRIER, "v12"))).toBe("Collision pressed");
  });

  it("says a value that is plugged in by its own words", () => {
    expect(wordsOf(block(put(CARRIER, "v5", "value", "Count.Value"), "v5"))).toBe("Sign = Count");
  });

  it("joins two tests by the constructor's name and leaves a hole for a missing one", () => {
    const joined = put(CARRIER, "v4", "condition", "And");
    expect(piecesOf(block(joined, "v21"))).toMatchObject([
      { kind: "words", words: "Sign = 0 and" },
      { kind: "hole", vertex: "v21", slot: "right" },
    ]);
    expect(wordsOf(block(put(joined, "v21", "right", "Cargo.IsPressed"), "v21"))).toBe("Sign = 0 and Cargo pressed");
  });

  it("puts brackets around another joining inside", () => {
    const both = put(put(CARRIER, "v4", "condition", "Or"), "v21", "right", "Cargo.IsPressed");
    const all = put(put(both, "v4", "condition", "And"), "v23", "right", "Run.IsTrue");
    expect(wordsOf(block(all, "v23"))).toBe("(Sign = 0 or Cargo pressed) and Run is true");
  });

  it("writes a constructor of one test in front of it", () => {
    expect(wordsOf(block(put(CARRIER, "v4", "condition", "No"), "v21"))).toBe("no Sign = 0");
  });
});

describe("a field in words", () => {
  it("is the number typed, a switch's true or false, or what is plugged in", () => {
    expect(fieldWords(block(CARRIER, "v8"), "speed")).toBe("50 %");
    expect(fieldWords(block(put(CARRIER, "v8", "speed", "Count.Value"), "v8"), "speed")).toBe("Count");
    const place: Place = { kind: "arc", source: "v13", out: "next" };
    const set = insertPart(CARRIER, PARTS, place, "Run.Set")?.execute(missionOf(CARRIER)).programs[0] ?? CARRIER;
    expect(fieldWords(block(set, "v21"), "value")).toBe("true");
  });
});
