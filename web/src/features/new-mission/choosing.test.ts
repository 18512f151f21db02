import { expect, test } from "vitest";

import type { Beginnings, Kit, BeginningPlace, Starter } from "../../api/generated";
import { fittingFirst, NOTHING, settled, starterFits } from "./choosing";

const words = { label: {}, help: {} };
const kit = (name: string, ...places: string[]): Kit => ({ name, ...words, robots: [], can: [], feels: [], places });
const place = (name: string) => ({ name, ...words }) as BeginningPlace;
const starter = (name: string, places: Record<string, string[]>): Starter => ({ name, ...words, places });

const ALL: Beginnings = {
  kits: [kit("rover", "floor", "maze"), kit("board", "desk"), kit("alone")],
  places: [place("floor"), place("maze"), place("desk")],
  starters: [starter("square", { rover: ["floor"] }), starter("heart", { board: ["desk"] })],
};

test("a choice that fits stays", () => {
  const choice = { kit: "rover", place: "floor", starter: "square" };
  expect(settled(ALL, choice)).toEqual(choice);
});

test("another kit takes the place and the starter with it", () => {
  expect(settled(ALL, { kit: "board", place: "floor", starter: "square" })).toEqual({
    kit: "board",
    place: "desk",
    starter: "heart",
  });
});

test("where no starter fits there is the one without parts, and it stays when it was wished", () => {
  expect(settled(ALL, { kit: "rover", place: "maze", starter: "square" }).starter).toBe(NOTHING);
  expect(settled(ALL, { kit: "rover", place: "floor", starter: NOTHING }).starter).toBe(NOTHING);
});

test("what is not known is the first there is, and nothing at all changes nothing", () => {
  expect(settled(ALL, { kit: "", place: "", starter: "" })).toEqual({
    kit: "rover",
    place: "floor",
    starter: "square",
  });
  expect(settled(ALL, { kit: "alone", place: "floor", starter: "" })).toEqual({
    kit: "alone",
    place: "",
    starter: NOTHING,
  });
  const none = { kits: [], places: [], starters: [] };
  expect(settled(none, { kit: "a", place: "b", starter: "c" })).toEqual({ kit: "a", place: "b", starter: "c" });
});

test("what does not fit goes to the end of its row", () => {
  const choice = { kit: "board", place: "desk", starter: "" };
  const order = fittingFirst(ALL.starters, (one) => starterFits(one, choice));
  expect(order.map(({ name }) => name)).toEqual(["heart", "square"]);
});
