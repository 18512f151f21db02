import { describe, expect, it } from "vitest";

import type { Mission } from "../../model/types";
import { applyMessage, type BoardsState, kitFor, networkAddress, placesOf, programFor, readKept } from "./boards";
import { recordingName } from "./recording";
import { systemOf } from "./Robots";
import { runOf, shownBoards } from "./board-run";
import { bodyOf, placesFor, withBody } from "./team";
import type { Board } from "./wire";

const BOARD: Board = {
  type: "board",
  address: "/dev/ttyACM0",
  name: "micro:bit",
  holder: "page-1",
  phase: "open",
  state: "running",
  held: true,
  free: 2048,
  generation: 1,
  package: "c0ffee00",
  installed: "12345678",
  program: "heart",
  progress: null,
  fault: null,
  message: "",
  help: "",
  way: "",
  micropython: "",
  recorded: false,
  bench: null,
};

const STATE: BoardsState = {
  you: "page-1",
  key: "k",
  barred: null,
  ports: [{ address: "/dev/ttyACM0", name: "micro:bit", description: "DAPLink", firmware: "" }],
  boards: {},
  steps: {},
  refused: {},
  given: {},
  chosen: {},
  kits: {},
  typed: [],
  bodies: {},
  team: null,
};

function board(more: Partial<Board> = {}): Board {
  return { ...BOARD, ...more };
}

describe("addresses on the network", () => {
  it.each([
    ["socket://127.0.0.1:4000", "socket://127.0.0.1:4000"],
    [" 192.168.4.1:4000 ", "socket://192.168.4.1:4000"],
    ["robot.local:23", "socket://robot.local:23"],
    ["rfc2217://robot:2217", "rfc2217://robot:2217"],
    ["[::1]:4000", "socket://[::1]:4000"],
  ])("takes %s", (text, address) => {
    expect(networkAddress(text)).toBe(address);
  });

  it.each([
    "",
    "robot",
    "socket://robot",
    "spy://robot:1",
    "robot:0",
    "robot:65536",
    "a b:1",
    "socket://a:1?logging=x",
    "user@a:1",
  ])("does not take %s", (text) => {
    expect(networkAddress(text)).toBeNull();
  });

  it("remembers only what makes sense", () => {
    expect(readKept(null)).toEqual({ chosen: {}, kits: {}, typed: [], bodies: {} });
    expect(readKept("{")).toEqual({ chosen: {}, kits: {}, typed: [], bodies: {} });
    expect(readKept('{"chosen": {"a": "b", "c": 1}, "typed": ["socket://a:1", "spy://x", 3]}')).toEqual({
      chosen: { a: "b" },
      kits: {},
      typed: ["socket://a:1"],
      bodies: {},
    });
  });
});

describe("the boards of a team", () => {
  it("gives a board to one agent of a mission, and leaves other missions alone", () => {
    const before = withBody({ "b.krt\nants": "COM3" }, "a.krt", "one", "COM3");
    expect(bodyOf({ bodies: before }, "a.krt", "one")).toBe("COM3");
    const after = withBody(before, "a.krt", "two", "COM3");
    expect(["one", "two"].map((agent) => bodyOf({ bodies: after }, "a.krt", agent))).toEqual(["", "COM3"]);
    expect(withBody(after, "a.krt", "two", "")).toEqual({ "b.krt\nants": "COM3" });
  });

  it("can be chosen though they are not there", () => {
    const chosen = placesFor(STATE, "socket://h:1").map(({ address }) => address);
    expect(chosen).toEqual(["/dev/ttyACM0", "socket://h:1"]);
    expect(placesFor(STATE, "")).toHaveLength(1);
  });
});

describe("what the server tells", () => {
  it("keeps a robot as a whole, until it is gone", () => {
    const there = { ...STATE, ...applyMessage(STATE, BOARD) };
    expect(there.boards).toEqual({ "/dev/ttyACM0": BOARD });
    const given = {
      ...there,
      given: { "/dev/ttyACM0": { path: "", program: "heart", kit: "", mission: null as never } },
    };
    const gone = { ...given, ...applyMessage(given, { type: "gone", address: "/dev/ttyACM0" }) };
    expect([gone.boards, gone.given]).toEqual([{}, {}]);
  });

  it("keeps a refusal with its robot, and one about nobody for all", () => {
    const refusal = { type: "refused" as const, message: "No.", help: "", problems: [] };
    expect(applyMessage(STATE, { ...refusal, address: "a" }).refused?.["a"]?.message).toBe("No.");
    expect(applyMessage(STATE, { ...refusal, address: "" }).barred?.message).toBe("No.");
  });
});

describe("the list", () => {
  it("holds ports, then robots on the network, then those that were pulled out", () => {
    const boards = { "/dev/ttyACM7": board({ address: "/dev/ttyACM7", phase: "lost" }) };
    const places = placesOf({ ...STATE, boards, typed: ["socket://a:1"] });
    expect(places.map(({ address, name, board }) => [address, name, board?.phase])).toEqual([
      ["/dev/ttyACM0", "micro:bit", undefined],
      ["socket://a:1", "a:1", undefined],
      ["/dev/ttyACM7", "micro:bit", "lost"],
    ]);
  });

  it("is built of what was chosen for it, else of what was chosen last, else of what its own file says", () => {
    expect(kitFor({ kits: {} }, "a")).toBe("");
    expect(kitFor({ kits: { a: "xrp", "": "pico" } }, "a")).toBe("xrp");
    expect(kitFor({ kits: { a: "xrp", "": "pico" } }, "b")).toBe("pico");
    expect(kitFor({ kits: { a: "", "": "pico" } }, "a")).toBe("");
  });

  it("offers the chosen program, else the one on the robot, else the open one", () => {
    const state = { chosen: {}, boards: { a: board({ program: "heart" }) } };
    expect(programFor({ ...state, chosen: { a: "dice" } }, "a", ["dice", "heart", "open"], "open")).toBe("dice");
    expect(programFor({ ...state, chosen: { a: "gone" } }, "a", ["dice", "heart", "open"], "open")).toBe("heart");
    expect(programFor(state, "b", ["dice", "heart", "open"], "open")).toBe("open");
    expect(programFor(state, "b", [], "open")).toBe("");
  });
});

describe("robots as a run", () => {
  const given = { "/dev/ttyACM0": { path: "m.krt", program: "heart", kit: "", mission: null as never } };

  it("shows those that this page holds, with a program of the mission that is open", () => {
    const shown = (more: Partial<Board>, path = "m.krt") =>
      shownBoards({ ...STATE, given, boards: { "/dev/ttyACM0": board(more) } }, path).length;
    expect([shown({}), shown({ program: "" }), shown({ holder: "page-2" }), shown({}, "other.krt")]).toEqual([
      1, 0, 0, 0,
    ]);
  });

  it("is of those with the same programs as the one that runs and was given them last", () => {
    const [old, now] = [{ programs: [] }, { programs: [] }];
    const give = (mission: object) => ({ path: "m.krt", program: "heart", kit: "", mission: mission as Mission });
    const boards = {
      a: board({ address: "a" }),
      b: board({ address: "b", state: "ready" }),
      c: board({ address: "c" }),
    };
    const run = (given: Record<string, Mission | object>, changed: object = {}) => {
      const all = Object.fromEntries(Object.entries(given).map(([address, mission]) => [address, give(mission)]));
      return runOf({ ...STATE, boards: { ...boards, ...changed }, given: all }, "m.krt")?.boards.map(
        (one) => one.address,
      );
    };
    expect(run({ a: now, b: now, c: now })).toEqual(["a", "b", "c"]);
    expect(run({ a: old, b: now, c: now })).toEqual(["b", "c"]);
    expect(run({ c: now, b: now, a: old })).toEqual(["a"]);
    expect(run({ a: now, b: old }, { a: board({ address: "a", phase: "lost" }) })).toBeUndefined();
  });
});

it.each([
  [{ program: "heart", name: "micro:bit" }, "heart-micro-bit.krtrace"],
  [{ program: "دل", name: "127.0.0.1:4000" }, "دل-127.0.0.1-4000.krtrace"],
  [{ program: "", name: "../../x" }, "..-..-x.krtrace"],
])("names the file of a recording after %o", (board, name) => {
  expect(recordingName(board)).toBe(name);
});

it("knows the kind of computer that the page is on", () => {
  expect(systemOf("Mozilla/5.0 (X11; Linux x86_64)")).toBe("linux");
  expect(systemOf("Mozilla/5.0 (Windows NT 10.0; Win64; x64)")).toBe("windows");
  expect(systemOf("Mozilla/5.0 (Linux; Android 14)")).toBe("other");
});
