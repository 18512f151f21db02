import { expect, test } from "vitest";

import type { Beginnings, RobotSet, BeginningPlace, Starter } from "../../api/generated";
import { fittingFirst, NOTHING, settled, starterFits } from "./choice";

const words = { label: {}, help: {} };
const robotSet = (name: string, ...places: string[]): RobotSet => ({
  name,
  ...words,
  robots: [],
  own: false,
  can: [],
  feels: [],
  places,
});
const place = (name: string) => ({ name, ...words }) as BeginningPlace;
const starter = (name: string, places: Record<string, string[]>): Starter => ({ name, ...words, places });

const ALL: Beginnings = {
  robot_sets: [robotSet("rover", "floor", "maze"), robotSet("board", "desk"), robotSet("alone")],
  places: [place("floor"), place("maze"), place("desk")],
  starters: [starter("square", { rover: ["floor"] }), starter("heart", { board: ["desk"] })],
};

test("a choice that fits stays", () => {
  const choice = { robotSet: "rover", place: "floor", starter: "square" };
  expect(settled(ALL, choice)).toEqual(choice);
});

test("another robotSet takes the place and the starter with it", () => {
  expect(settled(ALL, { robotSet: "board", place: "floor", starter: "square" })).toEqual({
    robotSet: "board",
    place: "desk",
    starter: "heart",
  });
});

test("where no starter fits there is the one without parts, and it stays when it was wished", () => {
  expect(settled(ALL, { robotSet: "rover", place: "maze", starter: "square" }).starter).toBe(NOTHING);
  expect(settled(ALL, { robotSet: "rover", place: "floor", starter: NOTHING }).starter).toBe(NOTHING);
});

test("what is not known is the first there is, and nothing at all changes nothing", () => {
  expect(settled(ALL, { robotSet: "", place: "", starter: "" })).toEqual({
    robotSet: "rover",
    place: "floor",
    starter: "square",
  });
  expect(settled(ALL, { robotSet: "alone", place: "floor", starter: "" })).toEqual({
    robotSet: "alone",
    place: "",
    starter: NOTHING,
  });
  const none = { robot_sets: [], places: [], starters: [] };
  expect(settled(none, { robotSet: "a", place: "b", starter: "c" })).toEqual({
    robotSet: "a",
    place: "b",
    starter: "c",
  });
});

test("what does not fit goes to the end of its row", () => {
  const choice = { robotSet: "board", place: "desk", starter: "" };
  const order = fittingFirst(ALL.starters, (one) => starterFits(one, choice));
  expect(order.map(({ name }) => name)).toEqual(["heart", "square"]);
});
