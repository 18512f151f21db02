import { expect, test } from "vitest";

import { isOlder } from "./Firmware";

test("a version is older by its numbers, not by its letters", () => {
  expect(isOlder("1.9", "1.20")).toBe(true);
  expect(isOlder("1.20", "1.20")).toBe(false);
  expect(isOlder("1.20.1", "1.20")).toBe(false);
  expect(isOlder("1.20", "1.20.1")).toBe(true);
  expect(isOlder("1.24.0", "1.24.1")).toBe(true);
  expect(isOlder("1.24.10", "1.24.9")).toBe(false);
  expect(isOlder("2.0", "1.25")).toBe(false);
  expect(isOlder("1", "1.1")).toBe(true);
});

test("a preview is older than its release, and later than the release before", () => {
  expect(isOlder("1.25.0-preview", "1.25")).toBe(true);
  expect(isOlder("1.25.0-preview", "1.25.0-preview")).toBe(false);
  expect(isOlder("1.25.0", "1.25.0-preview")).toBe(false);
  expect(isOlder("1.25.1-preview", "1.25")).toBe(false);
  expect(isOlder("1.24.1", "1.25.0-preview")).toBe(true);
});
