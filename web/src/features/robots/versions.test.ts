import { expect, test } from "vitest";

import { isOlder } from "./versions";

test("a version is older by its numbers, not by its letters", () => {
  expect(isOlder("1.9", "1.20")).toBe(true);
  expect(isOlder("1.20", "1.20")).toBe(false);
  expect(isOlder("1.20.1", "1.20")).toBe(false);
  expect(isOlder("1.20", "1.20.1")).toBe(false);
  expect(isOlder("2.0", "1.25")).toBe(false);
  expect(isOlder("1", "1.1")).toBe(true);
});
