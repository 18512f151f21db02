import { beforeAll, describe, expect, it } from "vitest";

import { moreWords } from "../../../i18n/words";

import { accountOf, deedWords, drawnWords, type Facts, lengthWords } from "./account";
import { awaitedAt } from "./awaited-sensors";
import type { Deed } from "./deeds";
import type { Line } from "./shape";

beforeAll(moreWords);

const SQUARE: Line = [
  [0, 0],
  [300, 0],
  [300, 300],
  [0, 300],
  [0, 1],
];
const NOTHING: Facts = {
  done: true,
  sentence: "Done after 8.0 s.",
  atOnce: false,
  goals: { reached: 0, count: 0 },
  lines: [],
  driven: [{ name: "robot-1", mm: 0 }],
  tickMs: 20,
  deeds: [],
  acted: false,
};

const PUSHED = { kind: "pushed", count: 1, mm: 800 } as const;

describe("what pens drew", () => {
  it("is a closed shape with its sides and corners", () => {
    expect(drawnWords([SQUARE])).toEqual({
      title: "You drew a closed shape.",
      more: ["4 sides of 30 cm, 4 corners of 90°."],
    });
  });

  it("is an open shape, a line, several shapes, or so much of lines", () => {
    expect(drawnWords([SQUARE.slice(0, 4)])).toEqual({
      title: "You drew an open shape.",
      more: ["3 sides of 30 cm, 2 corners of 90°."],
    });
    expect(drawnWords([SQUARE.slice(0, 2)])?.title).toBe("You drew a line of 30 cm.");
    const other = SQUARE.map(([x, y]): [number, number] => [x + 1000, y]);
    expect(drawnWords([SQUARE, other])?.title).toBe("You drew 2 closed shapes.");
    expect(drawnWords([SQUARE.slice(0, 2), other.slice(0, 2)])?.title).toBe("You drew 60 cm of lines.");
    expect(drawnWords([])).toBeNull();
  });

  it("names no common length where sides differ", () => {
    const long: Line = [
      [0, 0],
      [600, 0],
      [600, 300],
      [0, 300],
      [0, 0],
    ];
    expect(drawnWords([long])?.more).toEqual(["4 sides, 4 corners of 90°."]);
  });
});

describe("the card of a run", () => {
  it("says first what was drawn, then how far was driven, then how it ended", () => {
    const account = accountOf({ ...NOTHING, lines: [SQUARE], driven: [{ name: "robot-1", mm: 1204 }] });
    expect(account).toEqual({
      tone: "plain",
      title: "You drew a closed shape.",
      more: ["4 sides of 30 cm, 4 corners of 90°.", "robot-1 drove 1.2 m.", "Done after 8.0 s."],
    });
  });

  it("is green for goals and only for all of them", () => {
    const all = accountOf({ ...NOTHING, goals: { reached: 3, count: 3 }, deeds: [PUSHED] });
    expect([all.tone, all.title, all.more[0]]).toEqual(["goal", "3 of 3 goals.", "1 thing was pushed, over 80 cm."]);
    const some = accountOf({ ...NOTHING, goals: { reached: 1, count: 3 }, deeds: [PUSHED] });
    expect([some.tone, some.more]).toEqual(["plain", ["1 of 3 goals.", "Done after 8.0 s."]]);
  });

  it("is amber where nothing moved and where a program ended at once, and plain where something shone", () => {
    expect(accountOf(NOTHING)).toEqual({ tone: "nothing", title: "Nothing moved.", more: ["Done after 8.0 s."] });
    const once = accountOf({ ...NOTHING, atOnce: true, sentence: "Done after 0.0 s: at once." });
    expect([once.tone, once.title]).toEqual(["nothing", "Done after 0.0 s: at once."]);
    const lit = accountOf({ ...NOTHING, acted: true });
    expect([lit.tone, lit.title]).toEqual(["plain", "Done after 8.0 s."]);
  });

  it("begins with the most telling deed, then how far was driven, and says no more than five", () => {
    const account = accountOf({
      ...NOTHING,
      driven: [{ name: "robot-1", mm: 1204 }],
      deeds: [
        { kind: "found", name: "robot-1", colour: "red", tick: 1550 },
        { kind: "lit", name: "robot-1", robots: 1, count: 4 },
        { kind: "counted", name: "Count", value: 4 },
        { kind: "used", name: "robot-1", parts: ["Display", "Music"] },
        { kind: "untouched" },
      ],
    });
    expect([account.tone, account.title]).toEqual(["plain", "robot-1 found red after 31.0 s."]);
    expect(account.more).toEqual([
      "robot-1 drove 1.2 m.",
      "The lamp of robot-1 went on 4 times.",
      "Count is 4 now.",
      "robot-1 used: Display, Music.",
      "Done after 8.0 s.",
    ]);
  });

  it("says each kind of deed as a sentence", () => {
    const robot = "robot-1";
    const deeds: [Deed, string][] = [
      [{ kind: "delivered", done: 2, total: 3 }, "2 of 3 delivered."],
      [{ kind: "pushed", count: 2, mm: 1200 }, "2 things were pushed, up to 1.2 m far."],
      [{ kind: "left", name: robot, colour: "green", tick: 50 }, "robot-1 left the green floor after 1.0 s."],
      [{ kind: "followed", name: robot, mm: 4000 }, "robot-1 followed the line for 4 m."],
      [{ kind: "returned", name: robot, count: 1 }, "robot-1 came back to where it began."],
      [{ kind: "returned", name: robot, count: 2 }, "2 robots came back to where they began."],
      [{ kind: "before-wall", name: robot, mm: 84 }, "robot-1 stopped 8 cm before a wall."],
      [{ kind: "changed", name: robot, text: "takes over for robot-2" }, "robot-1 takes over for robot-2."],
      [{ kind: "apart", count: 3, least: 360, most: 520 }, "3 robots drove in a row, 36 cm to 52 cm apart."],
      [{ kind: "touched", count: 1 }, "Something was touched 1 time."],
      [{ kind: "lit", name: robot, robots: 2, count: 4 }, "Lamps of 2 robots went on 4 times in all."],
      [{ kind: "turned", name: robot, angle: 360 }, "robot-1 turned by 360° on the spot."],
    ];
    expect(deeds.map(([deed]) => deedWords(deed, 20))).toEqual(deeds.map(([, words]) => words));
  });

  it("leaves a failure to the run's own words", () => {
    expect(accountOf({ ...NOTHING, done: false, lines: [SQUARE] })).toEqual({
      tone: "failure",
      title: "Done after 8.0 s.",
      more: [],
    });
  });

  it("says lengths in cm up to a metre", () => {
    expect([304, 994, 1000, 1590].map(lengthWords)).toEqual(["30 cm", "99 cm", "1 m", "1.59 m"]);
  });
});

describe("what a robot waits for", () => {
  const vertex = (id: string, element: string) => ({ id, element }) as never;
  const arc = (source: string, target: string, at: string) => ({ source, target, out: "", at });
  const program = {
    vertices: [vertex("a", "When"), vertex("b", "No"), vertex("c", "Eye.LessThan"), vertex("d", "Ear.Hears")],
    arcs: [arc("b", "a", "condition"), arc("c", "b", "condition"), arc("d", "a", "return"), arc("a", "d", "")],
  };

  it("are the sensors in the conditions where it stands, and no others", () => {
    expect([...awaitedAt(program, ["a"])]).toEqual(["Eye"]);
    expect([...awaitedAt(program, [])]).toEqual([]);
  });
});
