import { describe, expect, it } from "vitest";

import { emptyProgram } from "./commands/changePrograms";
import { delta, DeltaError, patch, type Plain } from "./delta";
import { follow, type History, historyOf, isUnsaved } from "./history";
import { useStudio } from "./studio";
import type { Mission } from "./types";

/** Numbers that look random and are the same each time. */
function dice(seed: number): (sides: number) => number {
  let state = seed;
  return (sides) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * sides);
  };
}

function randomValue(roll: (sides: number) => number, depth: number): Plain {
  const kind = roll(depth > 0 ? 6 : 3);
  if (kind === 0) return roll(4);
  if (kind === 1) return ["a", "b", ""][roll(3)] ?? "";
  if (kind === 2) return roll(2) === 0 ? null : true;
  if (kind < 5) return Array.from({ length: roll(5) }, () => randomValue(roll, depth - 1));
  return Object.fromEntries(["x", "y", "z"].slice(roll(3)).map((name) => [name, randomValue(roll, depth - 1)]));
}

describe("a delta", () => {
  it("put on the first value gives the second, for any two values, through text as well", () => {
    const roll = dice(7);
    for (let round = 0; round < 3000; round++) {
      const [before, after] = [randomValue(roll, 4), randomValue(roll, 4)];
      const change = JSON.parse(JSON.stringify(delta(before, after))) as ReturnType<typeof delta>;
      expect(patch(before, change)).toStrictEqual(after);
    }
  });

  it("of equal values is nothing", () => {
    expect(delta({ a: [1, { b: "c" }] }, { a: [1, { b: "c" }] })).toBeNull();
  });

  it("keeps the order of fields, which is the order of the file", () => {
    const after = patch({ a: 1, b: 2 }, delta({ a: 1, b: 2 }, { b: 2, a: 1 }));
    expect(Object.keys(after as object)).toEqual(["b", "a"]);
  });

  it("is small when one element of many changed or was added", () => {
    const many = Array.from({ length: 1000 }, (_, at) => ({ id: String(at) }));
    expect(JSON.stringify(delta(many, [...many.slice(0, 500), { id: "new" }, ...many.slice(500)])).length).toBeLessThan(
      40,
    );
    expect(JSON.stringify(delta(many, many.with(3, { id: "x" }))).length).toBeLessThan(40);
  });

  it.each<[Plain, ReturnType<typeof delta>]>([
    [1, { o: { a: null } }],
    [{}, { o: { a: { v: 1 } } }],
    [{}, { e: [[0, null]] }],
    [[1], { e: [[1, { v: 2 }]] }],
    [[1], { s: [1, 1, []] }],
  ])("that does not fit %j is refused", (before, change) => {
    expect(() => patch(before, change)).toThrow(DeltaError);
  });
});

describe("the history", () => {
  const mission: Mission = { version: 1, programs: [emptyProgram("p", "r")], agents: [], goals: [], world: "" };
  const file = (read: Mission) => ({
    path: "a.krt",
    name: "a.krt",
    revision: "r",
    mission: read,
    problems: [],
    world: null,
    catalogue: { groups: [], robots: [], problems: [] },
  });

  /** Edits, undoes, redoes and saves at random; gives the history that followed along. */
  function wander(seed: number, steps: number): History {
    const roll = dice(seed);
    useStudio.getState().openMission(file(mission));
    let history = historyOf(mission);
    const stop = useStudio.subscribe((state, before) => {
      if (state.change !== before.change) history = follow(history, state.change, state.mission);
    });
    for (let step = 0; step < steps; step++) {
      const studio = useStudio.getState();
      const kind = roll(8);
      if (kind < 2) studio.undo();
      else if (kind < 3) studio.redo();
      else if (kind < 4) studio.markSaved("a.krt", `r${String(step)}`);
      else {
        const before = studio.mission;
        const after = { ...before, world: `w${String(step)}` };
        const joins = kind < 6 ? {} : { joins: "typing" };
        studio.execute({ label: `Step ${String(step)}`, execute: () => after, ...joins });
      }
    }
    stop();
    return history;
  }

  it("is told by what the store announces, through edits, joined edits, undo, redo and saves", () => {
    for (let seed = 1; seed < 60; seed++) {
      const history = wander(seed, 40);
      const { mission: now, dirty, canUndo, canRedo, undoLabel, redoLabel } = useStudio.getState();
      expect(history.mission).toBe(now);
      const { past, future, saved } = useStudio.getState().history;
      expect([past.length, future.length, saved]).toEqual([history.past.length, history.future.length, history.saved]);
      expect([dirty, canUndo, canRedo]).toEqual([
        isUnsaved(history),
        history.past.length > 0,
        history.future.length > 0,
      ]);
      expect([undoLabel, redoLabel]).toEqual([history.past.at(-1)?.label ?? "", history.future.at(-1)?.label ?? ""]);
    }
  });

  it("opened again, undoes to the first state and redoes to the last", () => {
    const history = wander(11, 60);
    useStudio.getState().openMission(file(mission), history);
    expect(useStudio.getState().mission).toBe(history.mission);
    while (useStudio.getState().canUndo) useStudio.getState().undo();
    expect(useStudio.getState().mission).toBe(mission);
    while (useStudio.getState().canRedo) useStudio.getState().redo();
    expect(useStudio.getState().mission).toBe((history.future[0] ?? history.past.at(-1))?.after);
  });
});
