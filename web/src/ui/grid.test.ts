import { expect, test } from "vitest";

import { walkGrid } from "./grid";

test("keys walk to the edges and no further, and turn with the way of writing", () => {
  const size = { row: 2, column: 3 };
  const from = { row: 0, column: 2 };
  expect(walkGrid("ArrowRight", from, size, "ArrowRight")).toEqual(from);
  expect(walkGrid("ArrowRight", from, size, "ArrowLeft")).toEqual({ row: 0, column: 1 });
  expect(walkGrid("ArrowDown", from, size, "ArrowRight")).toEqual({ row: 1, column: 2 });
  expect(walkGrid("Home", from, size, "ArrowRight")).toEqual({ row: 0, column: 0 });
  expect(walkGrid("PageDown", from, size, "ArrowRight")).toEqual({ row: 1, column: 2 });
  expect(walkGrid("a", from, size, "ArrowRight")).toBeNull();
});
