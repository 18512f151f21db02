import { expect, test } from "vitest";

import type { MissionEntry } from "../../api/generated";
import { text } from "../../model/texts";
import { ALL, byLevel, fitting, robotsOf, topicsOf } from "./filter";

function example(name: string, level: number, topics: string[], robots = ["mini-robot"]): MissionEntry {
  return {
    path: `example:${name}/${name}.krt`,
    name,
    title: "",
    modified: "",
    label: { "": name, fr: `${name} carré` },
    help: { "": "Four sides, four quarter turns." },
    example: {
      level,
      topics: topics.map((topic) => ({ name: topic, label: { "": `${topic} things`, fr: `Boucles ${topic}` } })),
      robots,
      agents: 1,
      parts: 3,
    },
    problem: "",
  };
}

const SQUARE = example("square", 1, ["driving", "loops"]);
const HEART = example("heart", 1, ["light"], ["microbit"]);
const CONVOY = example("convoy", 3, ["teams", "driving"]);
const OTHER = example("other", 0, []);
const EVERY = [OTHER, CONVOY, HEART, SQUARE];
const name = (robot: string) => (robot === "microbit" ? "BBC micro:bit" : robot);
const found = (wish: Partial<typeof ALL>, language = "") =>
  fitting(EVERY, { ...ALL, ...wish }, (texts, fallback) => text(texts, fallback, language), name).map(
    (entry) => entry.name,
  );

test("nothing that is looked for is everything, and each filter leaves out what is not so", () => {
  expect(found({})).toEqual(["other", "convoy", "heart", "square"]);
  expect(found({ level: 1 })).toEqual(["heart", "square"]);
  expect(found({ topic: "driving" })).toEqual(["convoy", "square"]);
  expect(found({ robot: "microbit" })).toEqual(["heart"]);
  expect(found({ topic: "driving", level: 3 })).toEqual(["convoy"]);
  expect(found({ topic: "light", level: 3 })).toEqual([]);
});

test("every word has to stand somewhere: in title, help, topic or robot, in the reader's language, accents or not", () => {
  expect(found({ words: "  TURNS quarter " })).toEqual(["other", "convoy", "heart", "square"]);
  expect(found({ words: "light things" })).toEqual(["heart"]);
  expect(found({ words: "micro" })).toEqual(["heart"]);
  expect(found({ words: "carre square" }, "fr")).toEqual(["square"]);
  expect(found({ words: "carre" })).toEqual([]);
  expect(found({ words: "(((" })).toEqual([]);
  expect(found({ words: "CARRÉ" })).toEqual([]);
});

test("levels go from the easiest to the hardest, and what has none is last", () => {
  expect(byLevel(EVERY).map(({ level, entries }) => [level, entries.length])).toEqual([
    [1, 2],
    [3, 1],
    [0, 1],
  ]);
});

test("topics and robots are listed once", () => {
  expect(topicsOf(EVERY).map((topic) => topic.name)).toEqual(["driving", "teams", "light", "loops"]);
  expect(robotsOf(EVERY)).toEqual(["mini-robot", "microbit"]);
});
