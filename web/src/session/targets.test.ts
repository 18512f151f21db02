import { expect, it } from "vitest";

import { CARRIER_PARTS, WAITING_PARTS } from "../model/testing/missions";
import { acceptedPlaces } from "./targets";

it("what is dragged is taken by the places of its kind only", () => {
  const places = (element: string, moves = false, parts = WAITING_PARTS) =>
    acceptedPlaces(parts, parts.shape(element), moves);
  expect(places("While")).toBe("arcs");
  expect(places("Wheel.Advance")).toBe("arcs actions");
  expect(places("Collision.IsPressed")).toBe("arcs conditions");
  expect(places("Collision.IsPressed", true)).toBe("conditions");
  // Where nothing only waits, a test has no place among the arcs.
  expect(places("Collision.IsPressed", false, CARRIER_PARTS)).toBe("conditions");
  expect(places("Count.Value")).toBe("values");
});
