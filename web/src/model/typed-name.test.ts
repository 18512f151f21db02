import { expect, it } from "vitest";

import { typedName } from "./typed-name";

it("is one name, however a keyboard types it", () => {
  expect(typedName(" E\u0301tage ")).toBe("\u00c9tage");
  expect(typedName("\u0627\u0653\u062f\u0645")).toBe("\u0622\u062f\u0645");
  expect(typedName("  ")).toBe("");
});
