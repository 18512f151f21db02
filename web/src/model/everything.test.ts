/** Undo has no holes: whatever is done to a mission is taken back to the very same bytes, and done again. */
import { describe, expect, it } from "vitest";

import { delta, patch, type Plain } from "./delta";
import { type Change, follow, historyOf } from "./history";
import { useStudio } from "./studio";
import { randomChange } from "./testing/edits";
import { CARRIER, fileOf, growProgram, missionOf, randomFrom } from "./testing/missions";
import type { Mission } from "./types";

const bytes = (mission: Mission) => JSON.stringify(mission);
const KINDS = ["programs", "agents", "goals", "world", "label", "help", "variables", "constructors"] as const;

/** A mission that has a little of everything. */
function begin(seed: number): Mission {
  return {
    ...missionOf(growProgram(seed, 14, true), CARRIER),
    goals: [{ storehouse: "B", stock: "all" }],
    world: "ring.world.xml",
    label: { "": "Transport", ur: "نقل و حمل" },
    breakpoints: [{ program: "carrier", vertex: "v1", agents: ["carrier-1"], when: "Trips.EqualTo(2)" }],
    failures: [{ agent: "carrier-1", at_s: 3, kind: "fail" }],
  };
}

describe("edits of every kind", () => {
  it("are undone to the same bytes and done again to the same bytes, and the journal knows each of them", () => {
    const touched = new Set<string>();
    for (let seed = 1; seed <= 30; seed++) {
      const random = randomFrom(seed * 104729);
      useStudio.getState().openMission(fileOf(begin(seed)));
      const first = bytes(useStudio.getState().mission);
      let history = historyOf(useStudio.getState().mission);
      const states = [first];
      const hear = (change: Change) => {
        history = follow(history, change, useStudio.getState().mission);
        expect(bytes(history.mission)).toBe(bytes(useStudio.getState().mission));
      };
      for (let step = 0; step < 60; step++) {
        const before = useStudio.getState().mission;
        const command = randomChange(random, before);
        if (command === null) continue;
        useStudio.getState().execute(command);
        const { mission, change } = useStudio.getState();
        for (const kind of KINDS) if (mission[kind] !== before[kind]) touched.add(kind);
        if (change.kind === "join") states.pop();
        states.push(bytes(mission));
        hear(change);
        const written = delta(before as unknown as Plain, mission as unknown as Plain);
        expect(JSON.stringify(patch(before as unknown as Plain, written)), command.label).toBe(bytes(mission));
      }
      const { undo, redo } = useStudio.getState();
      for (const state of states.slice(0, -1).reverse()) {
        undo();
        expect(bytes(useStudio.getState().mission), `seed ${String(seed)}`).toBe(state);
        hear(useStudio.getState().change);
      }
      expect(useStudio.getState()).toMatchObject({ canUndo: false, dirty: false });
      expect(bytes(useStudio.getState().mission)).toBe(first);
      for (const state of states.slice(1)) {
        redo();
        expect(bytes(useStudio.getState().mission), `seed ${String(seed)}`).toBe(state);
        hear(useStudio.getState().change);
      }
      expect(useStudio.getState().canRedo).toBe(false);
    }
    expect([...touched].sort()).toEqual([...KINDS].sort());
  });
});
