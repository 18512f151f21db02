import { beforeAll, expect, test } from "vitest";

import type { Pupil } from "../../../api/generated";
import { moreWords } from "../../../i18n/words";
import { counts, filterOf, shown, sorted, stateWords, walkCards } from "./order";

beforeAll(moreWords);

function pupil(name: string, more: Partial<Pupil> = {}): Pupil {
  const plain: Pupil = {
    folder: name,
    name,
    word: "",
    state: "editing",
    seconds: null,
    running: false,
    file: "",
    version: 0,
    exercise: "",
    goals: [],
    pages: 1,
    frozen: false,
    turn: "pupil",
    mark: null,
  };
  return { ...plain, ...more };
}

const goals = (...reached: (boolean | null)[]) => reached.map((one) => ({ reached: one, why: "" }));
const all = [
  pupil("Ada", { goals: goals(true, true) }),
  pupil("Ben", { state: "stuck", seconds: 400, goals: goals(true, false) }),
  pupil("Çelik", { state: "asks", seconds: 60, goals: goals(false, false) }),
  pupil("Dana", { state: "done", goals: goals(true, true) }),
  pupil("فاطمہ", { state: "away", seconds: 600 }),
  pupil("Eve", { state: "stuck", seconds: 900, goals: goals(true, true) }),
];

test("who needs help longest comes first, then who has met fewest goals; who is away comes last", () => {
  expect(sorted(all, "help")).toEqual(["Eve", "Ben", "Çelik", "Ada", "Dana", "فاطمہ"]);
  expect(sorted(all, "goals").slice(0, 3)).toEqual(["Çelik", "فاطمہ", "Ben"]);
});

test("filters count everybody once, and find names whatever their case and marks", () => {
  expect(counts(all, 2)).toEqual({ all: 6, help: 3, work: 1, done: 1, away: 1 });
  expect(shown(all, "all", "celi", 2).map(({ name }) => name)).toEqual(["Çelik"]);
  expect(shown(all, "all", "فاط", 2)).toHaveLength(1);
  expect(shown(all, "done", "", 2).map(({ name }) => name)).toEqual(["Dana"]);
  expect(filterOf(pupil("Fay", { state: "running", goals: goals(true, true) }), 2)).toBe("done");
});

test("a state says for how many minutes it lasts, and counts on by itself", () => {
  const seen = { pupil: pupil("Ben", { state: "stuck" as const, seconds: 290 }), at: 1000 };
  expect(stateWords(seen, 0, 1000).words).toBe("stuck for 4 min");
  expect(stateWords(seen, 0, 71_000).words).toBe("stuck for 6 min");
  expect(stateWords({ pupil: pupil("Gil", { state: "away" }), at: 0 }, 0, 0).words).toBe("not here today");
});

test("arrows walk the cards, and stay among them", () => {
  expect(walkCards("ArrowRight", 0, 10, 4, false)).toBe(1);
  expect(walkCards("ArrowRight", 0, 10, 4, true)).toBe(0);
  expect(walkCards("ArrowDown", 5, 10, 4, false)).toBe(9);
  expect(walkCards("ArrowDown", 7, 10, 4, false)).toBe(7);
  expect(walkCards("End", 3, 10, 4, false)).toBe(9);
  expect(walkCards("a", 3, 10, 4, false)).toBeNull();
});
