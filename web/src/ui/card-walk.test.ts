import { expect, test } from "vitest";

import { nextCard } from "./grid";

// Two rows of three, and one card below.
const PLACES = [0, 1, 2, 3, 4, 5, 6].map((at) => ({ left: (at % 3) * 200, top: Math.floor(at / 3) * 220 }));

test("arrows go on in the row and to the card below or above", () => {
  expect(nextCard("ArrowRight", 0, PLACES, false)).toBe(1);
  expect(nextCard("ArrowRight", 2, PLACES, false)).toBe(3);
  expect(nextCard("ArrowLeft", 0, PLACES, true)).toBe(1);
  expect(nextCard("ArrowDown", 1, PLACES, false)).toBe(4);
  expect(nextCard("ArrowDown", 5, PLACES, false)).toBe(6);
  expect(nextCard("ArrowUp", 5, PLACES, false)).toBe(2);
  expect(nextCard("Home", 5, PLACES, false)).toBe(0);
  expect(nextCard("End", 0, PLACES, false)).toBe(6);
});

test("from the first row upward is the search, and no key leads out otherwise", () => {
  expect(nextCard("ArrowUp", 1, PLACES, false)).toBe(-1);
  expect(nextCard("ArrowDown", 6, PLACES, false)).toBeNull();
  expect(nextCard("ArrowRight", 6, PLACES, false)).toBeNull();
  expect(nextCard("ArrowLeft", 0, PLACES, false)).toBeNull();
  expect(nextCard("x", 0, PLACES, false)).toBeNull();
  expect(nextCard("Home", 9, PLACES, false)).toBeNull();
});
