import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { CARRIER, missionOf } from "../model/testing/missions";
import type { Arc, Program, Report, Vertex } from "../model/types";
import { api } from "./client";
import type { SentMission, SentProgram } from "./generated";
import { drawn, forget, rowsOf } from "./known";

const MISSION = missionOf(CARRIER);
const { vertices, arcs } = CARRIER;
const extra: Vertex = { id: "extra", element: "Wait", settings: { duration: "3" }, notes: [] };

/** The report of a mission whose program the server knows by that name. */
function named(known: string): Report {
  return { programs: [{ name: CARRIER.name, lll: "", spans: [], instructions: 0, known }], problems: [] };
}

const gone = { message: "Not known.", help: "", problems: [] };
let answers: [status: number, body: unknown][] = [];
let bodies: { mission: SentMission }[] = [];

function answering(...given: typeof answers): void {
  answers = given;
}

function sentProgram(at = -1): SentProgram {
  const found = bodies.at(at)?.mission.programs[0];
  if (found === undefined) throw new Error("nothing was sent");
  return found;
}

function edited(one: Vertex = extra): Program {
  return { ...CARRIER, vertices: [...vertices.slice(0, 2), one, ...vertices.slice(2)] };
}

beforeEach(() => {
  forget();
  bodies = [];
  vi.stubGlobal(
    "fetch",
    vi.fn((_: string, { body }: { body: string }) => {
      bodies.push(JSON.parse(body) as { mission: SentMission });
      const [status, answer] = answers.shift() ?? [500, {}];
      return Promise.resolve(new Response(JSON.stringify(answer), { status }));
    }),
  );
});
afterEach(() => vi.unstubAllGlobals());

describe("a list as rows of another", () => {
  const [a, b, c, d] = [{ n: 1 }, { n: 2 }, { n: 3 }, { n: 4 }];
  it.each([
    ["the same", [a, b, c], [[0, 3]]],
    ["nothing", [], []],
    ["something put in", [a, d, b, c], [[0, 1], d, [1, 3]]],
    ["something taken out", [a, c], [[0, 1], [2, 3]]], // prettier-ignore
    ["something in the place of another", [a, d, c], [[0, 1], d, [2, 3]]],
    ["another order", [c, a, b], [[2, 3], [0, 2]]], // prettier-ignore
    ["all new", [d], [d]],
  ])("%s", (_, after, rows) => {
    expect(rowsOf([a, b, c], after)).toEqual(rows);
    const program = { ...CARRIER, vertices: [a, b, c] as unknown as Vertex[], arcs: [] as Arc[] };
    const back = drawn(program, { vertices: rows as never, arcs: [] });
    expect(back.vertices).toEqual(after);
    back.vertices.forEach((one, at) => expect(one).toBe(after[at]));
  });
});

describe("a mission", () => {
  it("is sent whole at first, then only what changed since the answer", async () => {
    answering([200, named("s-1")], [200, named("s-2")]);
    await api.check(MISSION, "a.krt");
    expect(bodies[0]?.mission).toEqual(JSON.parse(JSON.stringify(MISSION)));
    await api.check(missionOf(edited()), "a.krt");
    expect(sentProgram()).toMatchObject({ of: "s-1", vertices: [[0, 2], extra, [2, vertices.length]] });
    expect(sentProgram().arcs).toEqual([[0, arcs.length]]);
    answering([200, named("s-3")]);
    await api.check(MISSION, "a.krt");
    expect(sentProgram().of).toBe("s-2");
    expect(sentProgram().vertices).toEqual([[0, 2], [3, vertices.length + 1]]); // prettier-ignore
  });

  it("is sent whole to a server that has forgotten, and to one that gave no name", async () => {
    answering([200, named("s-1")], [410, gone], [200, named("")], [200, named("")]);
    await api.check(MISSION, "");
    await api.check(missionOf(edited()), "");
    expect([sentProgram(1).of, sentProgram(2).of]).toEqual(["s-1", undefined]);
    expect(sentProgram(2).vertices).toHaveLength(vertices.length + 1);
    await api.check(MISSION, "");
    expect(sentProgram().of).toBeUndefined();
  });

  it("that is refused for another reason is not sent twice", async () => {
    answering([422, gone]);
    await expect(api.check(MISSION, "")).rejects.toThrow("Not known.");
    expect(bodies).toHaveLength(1);
  });

  it("whose answer never came is sent as what changed since the one before", async () => {
    answering([200, named("s-1")], [500, {}], [200, named("s-2")]);
    await api.check(MISSION, "");
    await expect(api.check(missionOf(edited()), "")).rejects.toThrow();
    await api.check(missionOf(edited({ ...extra, id: "other" })), "");
    expect(sentProgram()).toMatchObject({ of: "s-1", vertices: [[0, 2], { id: "other" }, [2, vertices.length]] });
  });
});

describe("a report", () => {
  const spans = [
    { vertex: "v1", start: 0, end: 8, line: 1 },
    { vertex: "v2", start: 14, end: 21, line: 2 },
    { vertex: "v3", start: 23, end: 30, line: 3 },
  ];
  const whole: Report = {
    programs: [
      { name: CARRIER.name, lll: "WAIT(1);\n# 🙂\nWAIT(2);\nWAIT(3);\n", spans, instructions: 3, known: "s-1" },
    ],
    problems: [],
  };
  const change = (more: object) => ({
    programs: [
      { name: CARRIER.name, of: "s-1", at: 18, removed: 1, inserted: "245", instructions: 4, known: "s-2", ...more },
    ],
    problems: [],
  });

  it("is put together from the one before and what is different", async () => {
    const rows = [
      { start: 0, end: 1, characters: 0, lines: 0 },
      { vertex: "v2", start: 14, end: 23, line: 2 },
      { start: 2, end: 3, characters: 2, lines: 0 },
    ];
    answering([200, whole], [200, change({ spans: rows })]);
    await api.check(MISSION, "");
    const report = await api.check(missionOf(edited()), "");
    expect(report.programs).toEqual([
      {
        name: CARRIER.name,
        lll: "WAIT(1);\n# 🙂\nWAIT(245);\nWAIT(3);\n",
        spans: [spans[0], { vertex: "v2", start: 14, end: 23, line: 2 }, { vertex: "v3", start: 25, end: 32, line: 3 }],
        instructions: 4,
        known: "s-2",
      },
    ]);
    // The next one is told by what is different from this.
    answering([200, { ...change({ of: "s-2", at: 0, removed: 0, inserted: "", spans: [] }) }]);
    expect((await api.check(missionOf(edited()), "")).programs[0]?.lll).toBe(report.programs[0]?.lll);
  });

  it("that came with a typed text says of it what is said of the graph, where both are one", async () => {
    const told = { code: "x", severity: "warning", message: "m", help: "", program: CARRIER.name, vertices: ["v1"] };
    const place = { file: `${CARRIER.name}.lll`, line: 1, column: 1, end_line: 1, end_column: 3 };
    const problems = [
      { ...told, ...place },
      { ...told, ...place, program: "other" },
      { ...told, ...place, line: 0 },
    ];
    const same = { vertices: [[0, vertices.length]], arcs: [[0, arcs.length]] };
    answering([200, { program: same, spans: null, problems: null, report: { ...whole, problems } }]);
    const followed = await api.follow(MISSION, "", CARRIER.name, "text");
    expect(followed.spans).toEqual(spans);
    expect(followed.problems).toEqual([problems[0]]);
  });
});

describe("a typed text", () => {
  const rows = { vertices: [[0, 2], extra, [2, vertices.length]], arcs: [[0, arcs.length]] };
  const followed = { program: rows, spans: [], problems: [], report: named("s-7") };

  it("gives a program that keeps what did not change, and from which the next edit starts", async () => {
    answering([200, followed], [200, named("s-8")]);
    const { program } = await api.follow(MISSION, "a.krt", CARRIER.name, "text");
    expect(program?.vertices[1]).toBe(vertices[1]);
    expect(program?.vertices[2]).toEqual(extra);
    expect(program?.arcs).toBe(arcs);
    await api.check(missionOf(program ?? CARRIER), "a.krt");
    expect(sentProgram()).toMatchObject({ of: "s-7", vertices: [[0, vertices.length + 1]] });
  });

  it("of a program without arcs changes nothing either", () => {
    const bare = { ...CARRIER, arcs: [] };
    expect(drawn(bare, { vertices: [[0, vertices.length]], arcs: [] })).toBe(bare);
  });

  it("that says the same gives the very program, and one with mistakes gives none", async () => {
    const same = { vertices: [[0, vertices.length]], arcs: [[0, arcs.length]] };
    answering([200, { ...followed, program: same }], [200, { ...followed, program: null, report: null }]);
    expect((await api.follow(MISSION, "", CARRIER.name, "text")).program).toBe(CARRIER);
    expect((await api.follow(MISSION, "", CARRIER.name, "text(")).program).toBeNull();
  });
});
