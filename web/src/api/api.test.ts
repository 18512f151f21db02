import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { CARRIER, missionOf } from "../model/testing/missions";
import type { Program, Vertex } from "../model/types";
import { api, ApiError } from "./client";
import { socketAddress } from "./address";
import { forgetToken, token } from "./token";
import { decodeFrames } from "./wire";

function answer(status: number, body: unknown): void {
  const response = new Response(typeof body === "string" ? body : JSON.stringify(body), { status });
  vi.stubGlobal("fetch", vi.fn().mockResolvedValue(response));
}

async function refused(promise: Promise<unknown>): Promise<ApiError> {
  try {
    await promise;
  } catch (cause) {
    if (cause instanceof ApiError) return cause;
    throw cause;
  }
  throw new Error("it was not refused");
}

beforeEach(() => {
  localStorage.clear();
  forgetToken();
});
afterEach(() => {
  vi.unstubAllGlobals();
  window.history.replaceState(null, "", "/");
});

describe("the token", () => {
  it("moves from the address into the storage of this address", () => {
    window.history.replaceState(null, "", "/?token=abc&other=1");
    expect(token()).toBe("abc");
    expect(window.location.search).toBe("?other=1");
    forgetToken();
    expect(token()).toBe("abc");
  });

  it("is empty when the page was opened without one", () => {
    expect(token()).toBe("");
  });

  it("goes with every request", async () => {
    window.history.replaceState(null, "", "/?token=abc");
    answer(200, []);
    await api.missions();
    const [address, options] = vi.mocked(fetch).mock.calls[0] ?? [];
    expect(address).toBe("api/missions");
    expect(new Headers(options?.headers).get("X-KitRobot-Token")).toBe("abc");
  });
});

describe("a refusal", () => {
  it("carries the server's sentence and help", async () => {
    answer(404, { message: "There is no a.krt.", help: "Choose another." });
    const refusal = await refused(api.mission("a.krt"));
    expect([refusal.message, refusal.help, refusal.status]).toEqual(["There is no a.krt.", "Choose another.", 404]);
  });

  it("of a save keeps the revision on disk", async () => {
    answer(409, { message: "It changed.", help: "", revision: "r7" });
    const mission = { version: 1 as const, programs: [], agents: [], goals: [], world: "" };
    expect((await refused(api.saveMission("a.krt", "r1", mission))).revision).toBe("r7");
  });

  it("that is no JSON is said with its status", async () => {
    answer(502, "<html>bad gateway</html>");
    expect((await refused(api.session())).message).toBe("The server answered with status 502.");
  });

  it("without the token says where to get one", async () => {
    answer(401, {});
    expect((await refused(api.session())).help).toContain("token");
  });
});

it("a server that is gone is said in a sentence", async () => {
  vi.stubGlobal("fetch", vi.fn().mockRejectedValue(new TypeError("Failed to fetch")));
  expect((await refused(api.session())).message).toBe("The studio cannot reach kitrobot.");
});

it("a path is escaped in the address", async () => {
  answer(200, {});
  await api.mission("example:a b/c&d.krt");
  expect(vi.mocked(fetch).mock.calls[0]?.[0]).toBe("api/mission?path=example%3Aa%20b%2Fc%26d.krt");
});

it("the run's address keeps the page's folder and scheme", () => {
  const page = "https://h:1/lab/index.html";
  expect(socketAddress("api/run", page, "a/b").href).toBe("wss://h:1/lab/api/run?language=en&token=a%2Fb");
});

describe("a pose frame", () => {
  const frame = (numbers: number[]) => new Float32Array(numbers).buffer;

  it("is read robot by robot", () => {
    const [read] = decodeFrames(frame([7, 2, 0, 1, 2, 0.5, 1, 16, 3, 4, 0, 0, 0]));
    expect(read?.tick).toBe(7);
    expect(read?.poses[0]).toEqual({ x_mm: 1, y_mm: 2, heading_rad: 0.5, load: 1, flags: 16 });
    expect(read?.poses[1]?.y_mm).toBe(4);
  });

  it("comes after those of the way there, each with its things", () => {
    const one = [1, 2, 0.5, 0, 0];
    const read = decodeFrames(frame([16, 1, 1, ...one, 8, 9, 32, 1, 1, ...one, 10, 11]));
    expect(read.map(({ tick, things }) => [tick, things])).toEqual([
      [16, [[8, 9]]],
      [32, [[10, 11]]],
    ]);
  });

  it.each([
    ["is cut off", [7, 2, 0, 1, 2, 0.5]],
    ["has too many numbers", [7, 0, 0, 1]],
    ["has a count that is none", [7, Number.NaN, 0]],
    ["has a count below nought", [7, -1, 0]],
    ["has things below nought", [7, 1, -1, 1, 2, 3, 4, 5]],
    ["is empty", []],
  ])("that %s is dropped", (_, numbers) => {
    expect(decodeFrames(frame(numbers))).toEqual([]);
  });
});

describe("a typed text", () => {
  const { vertices, arcs } = CARRIER;
  const extra: Vertex = { id: "extra", element: "Wait", settings: { duration: "3" }, notes: [] };
  const follow = (program: Program | null) => {
    answer(200, { program: program && { ...program, level: "agent" }, spans: [], problems: [], report: null });
    return api.follow(missionOf(CARRIER), "a.krt", CARRIER.name, "text");
  };

  it("gives a program that keeps what did not change", async () => {
    const { program } = await follow({ ...CARRIER, vertices: [...vertices.slice(0, 2), extra, ...vertices.slice(2)] });
    expect(program?.vertices[1]).toBe(vertices[1]);
    expect(program?.vertices[2]).toEqual(extra);
    expect(program?.vertices[3]).toBe(vertices[2]);
    expect(program?.arcs).toBe(arcs);
  });

  it("that is the one which its graph prints has the places and problems of the report", async () => {
    const spans = [{ vertex: "v1", start: 0, end: 8, line: 1 }];
    const one = { code: "x", severity: "warning", message: "m", help: "", program: CARRIER.name, vertices: ["v1"] };
    const place = { file: `${CARRIER.name}.lll`, line: 1, column: 1, end_line: 1, end_column: 3 };
    const problems = [
      { ...one, ...place },
      { ...one, ...place, program: "other" },
      { ...one, ...place, line: 0 },
    ];
    const report = { programs: [{ name: CARRIER.name, lll: "WAIT(1);\n", spans, instructions: 3 }], problems };
    answer(200, { program: CARRIER, spans: null, problems: null, report });
    const followed = await api.follow(missionOf(CARRIER), "", CARRIER.name, "WAIT(1);\n");
    expect(followed.spans).toEqual(spans);
    expect(followed.problems).toEqual([problems[0]]);
  });

  it("that says the same gives the very program, and one with mistakes gives none", async () => {
    const told = (one: Vertex) => ({ ...one, unknown: one.unknown ?? "" });
    expect((await follow({ ...CARRIER, vertices: vertices.map(told) })).program?.vertices).toBe(vertices);
    expect((await follow(CARRIER)).program).toBe(missionOf(CARRIER).programs[0]);
    expect((await follow(null)).program).toBeNull();
  });
});
