import { expect, test } from "vitest";

import type { AskedProperty, Mission } from "../types";
import { freePropertyName, setProperties } from "./changeProperties";

const MISSION: Mission = { version: 1, programs: [], agents: [], goals: [], world: "" };
const ONE: AskedProperty = { name: "property-1", form: "never", first: "any a (B.C())", second: "" };

test("properties come, change and go, and a mission without any is as it was before", () => {
  const added = setProperties(MISSION, [ONE])?.execute(MISSION);
  expect(added?.properties).toEqual([ONE]);
  expect(setProperties(added ?? MISSION, [{ ...ONE }])).toBeNull();
  expect(setProperties(added ?? MISSION, [])?.execute(added ?? MISSION)).toEqual(MISSION);
});

test("a new one has a name of its own", () => {
  expect(freePropertyName([])).toBe("property-1");
  expect(freePropertyName([ONE, { ...ONE, name: "property-3" }])).toBe("property-2");
});
