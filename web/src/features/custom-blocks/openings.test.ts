import { expect, it } from "vitest";

import type { Offer } from "../../api/generated";
import { chosenOf, depthsOf, openingsOf } from "./openings";

function offer(vertex: string, slot: string, kind: Offer["kind"], inside: Offer["inside"] = null): Offer {
  const value = kind === "number" ? "5" : "";
  return { vertex, slot, kind, name: slot, label: {}, inside, is_open: false, value, min: 0, max: 9, unit: "" };
}

const OFFERS = [
  { ...offer("v1", "condition", "condition"), is_open: true },
  offer("v1", "body", "flow"),
  offer("v2", "n", "number", { vertex: "v1", slot: "body" }),
];

it("opens at first only what has to be open", () => {
  expect(chosenOf(openingsOf(OFFERS))).toEqual([{ vertex: "v1", slot: "condition", name: "condition" }]);
});

it("tells numbers with their range, and nothing of what is no number", () => {
  const openings = openingsOf(OFFERS).map((one) => ({
    ...one,
    on: one.key === "v2 n",
    min: "2",
    max: "x",
    first: " ",
  }));
  expect(chosenOf(openings)).toEqual([
    { vertex: "v2", slot: "n", name: "n", min: 2, max: null, default: null, unit: "" },
  ]);
});

it("leaves out what goes along with what holds it", () => {
  const openings = openingsOf(OFFERS).map((one) => ({ ...one, on: true }));
  expect(depthsOf(openings)).toEqual([0, 0, -1]);
  expect(chosenOf(openings).map(({ slot }) => slot)).toEqual(["condition", "body"]);
});
