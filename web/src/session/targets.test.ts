import { expect, it } from "vitest";

import { CARRIER_PARTS } from "../model/testing/missions";
import { acceptedPlaces } from "./targets";

it("what is dragged is taken by the places of its kind only", () => {
  const places = (element: string) => acceptedPlaces(CARRIER_PARTS.shape(element));
  expect(places("While")).toBe("arcs");
  expect(places("Wheel.Advance")).toBe("arcs actions");
  expect(places("Collision.IsPressed")).toBe("conditions");
});
