import { expect, test } from "vitest";

import { NOTHING, placeFor, readMemory } from "./hand-in-memory";

test("a mission that is begun anew is handed in beside what has its name; another one goes on where it was", () => {
  const memory = { ...NOTHING, places: { square: { name: "square 2.krt", revision: "r" } } };
  expect(placeFor(memory, "square", true)).toEqual({ name: "square", revision: "" });
  expect(placeFor(memory, "square", false)).toEqual({ name: "square 2.krt", revision: "r" });
  expect(placeFor(memory, "circle", false)).toEqual({ name: "circle", revision: "" });
});

test("what is remembered is read, and what makes no sense is not", () => {
  const whole = {
    places: { a: { name: "a.krt", revision: "r" } },
    waiting: { shown: "a", place: { name: "a", revision: "" }, mission: {}, exercise: "x" },
    begun: true,
    handed: 3,
    exercise: "x",
    note: 1,
    comments: { x: "Good" },
  };
  expect(readMemory(JSON.stringify(whole))).toEqual(whole);
  expect(readMemory('{"places":{"a":1},"waiting":{"shown":"a"},"handed":"x"}')).toEqual(NOTHING);
  const older = { ...whole, waiting: { ...whole.waiting, exercise: undefined } };
  expect(readMemory(JSON.stringify(older)).waiting?.exercise).toBe("");
  for (const text of [null, "", "{", "[]", "3"]) expect(readMemory(text)).toEqual(NOTHING);
});
