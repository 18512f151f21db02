import { describe, expect, it } from "vitest";

import type { Command } from "../command";
import { noteText } from "../notes";
import { readStructure, writeStructure } from "../structure";
import { useStudio } from "../studio";
import { randomEdit } from "../testing/edits";
import {
  CARRIER,
  CARRIER_PARTS as PARTS,
  fileOf,
  growProgram,
  missionOf,
  randomFrom,
  WAITING_PARTS,
} from "../testing/missions";
import type { Place } from "../tree";
import type { Program } from "../types";
import { addBranch, removeBranch } from "./changeBranches";
import { emptyProgram } from "./changePrograms";
import { deleteParts } from "./deleteParts";
import { insertPart } from "./insertPart";
import { copyParts, moveParts } from "./moveParts";
import { replaceElement } from "./replaceElement";
import { setField } from "./setField";
import { setNote } from "./setNote";
import { toggleMark } from "./toggleMark";

function after(program: Program, command: Command | null): Program {
  if (command === null) throw new Error("no command");
  const changed = command.execute(missionOf(program)).programs[0];
  if (changed === undefined) throw new Error("no program");
  return changed;
}

const lines = (program: Program) => program.arcs.map((arc) => `${arc.source}.${arc.out} → ${arc.target}.${arc.at}`);
const onArc = (source: string, out = "next"): Place => ({ kind: "arc", source, out });
const empty = emptyProgram("p", "carrier");

describe("insertPart", () => {
  it("splices into the arc, with an empty body that returns", () => {
    const program = after(empty, insertPart(empty, PARTS, onArc("start"), "While"));
    expect(lines(program)).toEqual(["start.next → v1.in", "v1.body → v1.return", "v1.next → stop.in"]);
  });

  it("makes as many branches as the slot asks for", () => {
    const program = after(empty, insertPart(empty, PARTS, onArc("start"), "Parallelism"));
    expect(lines(program)).toContain("v1.branch.2 → v1.return");
  });

  it("types the defaults in", () => {
    const program = after(empty, insertPart(empty, PARTS, onArc("start"), "Wheel.Advance"));
    expect(program.vertices[1]?.settings).toEqual({ speed: "50" });
  });

  it("waits for a test that comes into a chain, where something only waits", () => {
    const program = after(empty, insertPart(empty, WAITING_PARTS, onArc("start"), "Run.IsTrue"));
    expect(lines(program)).toEqual(["start.next → v2.in", "v1.next → v2.condition", "v2.next → stop.in"]);
    expect(program.vertices.find(({ id }) => id === "v2")?.element).toBe("Wait Until");
    expect(insertPart(empty, PARTS, onArc("start"), "Run.IsTrue")).toBeNull();
  });

  it("docks a test on a condition slot, and puts a test that was there away", () => {
    const place: Place = { kind: "slot", vertex: "v1", slot: "condition" };
    const program = after(CARRIER, insertPart(CARRIER, PARTS, place, "Cargo.IsPressed"));
    expect(lines(program)).toContain("v21.next → v1.condition");
    expect(program.vertices.some((one) => one.id === "v2")).toBe(false);
  });

  it("takes the test that was there into a joining condition", () => {
    const place: Place = { kind: "slot", vertex: "v1", slot: "condition" };
    const program = after(CARRIER, insertPart(CARRIER, PARTS, place, "And"));
    expect(lines(program)).toEqual(expect.arrayContaining(["v2.next → v21.left", "v21.next → v1.condition"]));
  });

  it("plugs a value into a parameter instead of the number", () => {
    const place: Place = { kind: "slot", vertex: "v8", slot: "speed" };
    const program = after(CARRIER, insertPart(CARRIER, PARTS, place, "Count.Value"));
    expect(program.vertices.find((one) => one.id === "v8")?.settings).toEqual({});
    const back = after(program, deleteParts(program, PARTS, ["v21"]));
    expect(back.vertices.find((one) => one.id === "v8")?.settings).toEqual({ speed: "50" });
  });

  it("parks on the void what hangs on nothing", () => {
    const program = after(CARRIER, insertPart(CARRIER, PARTS, { kind: "void" }, "While"));
    expect(program.vertices.at(-1)?.id).toBe("v21");
    expect(readStructure(program, PARTS).parked.length).toBe(1);
  });

  it("adds a branch to the parallel around the vertex it is dropped on", () => {
    const program = after(CARRIER, insertPart(CARRIER, PARTS, { kind: "vertex", vertex: "v6" }, "Branch"));
    expect(lines(program)).toContain("v3.branch.3 → v3.return");
  });

  it("refuses a test on an arc, a procedure in a condition and a branch where there is no parallel", () => {
    expect(insertPart(CARRIER, PARTS, onArc("v1"), "Cargo.IsPressed")).toBeNull();
    expect(insertPart(CARRIER, PARTS, { kind: "slot", vertex: "v1", slot: "condition" }, "Wheel.Stop")).toBeNull();
    expect(insertPart(empty, PARTS, { kind: "vertex", vertex: "start" }, "Branch")).toBeNull();
    expect(insertPart(CARRIER, PARTS, onArc("v99"), "While")).toBeNull();
  });
});

describe("deleteParts", () => {
  it("heals the arc and takes body and condition along", () => {
    const program = after(CARRIER, deleteParts(CARRIER, PARTS, ["v4"]));
    expect(lines(program)).toContain("v3.branch.1 → v3.return");
    expect(program.vertices.map((one) => one.id)).not.toContain("v5");
  });

  it("takes the mark of a marked action along", () => {
    const program = after(CARRIER, deleteParts(CARRIER, PARTS, ["v8"]));
    expect(lines(program)).toContain("v3.branch.2 → v9.in");
    expect(program.vertices.map((one) => one.id)).not.toContain("v7");
  });

  it("leaves Start and Stop", () => {
    expect(deleteParts(CARRIER, PARTS, ["start", "stop"])).toBeNull();
  });

  it("undoes an insertion exactly", () => {
    const with_ = after(CARRIER, insertPart(CARRIER, PARTS, onArc("v13"), "Repetition"));
    expect(after(with_, deleteParts(with_, PARTS, ["v21"]))).toEqual(CARRIER);
  });
});

describe("moveParts and copyParts", () => {
  it("moves a vertex with its body", () => {
    const program = after(CARRIER, moveParts(CARRIER, PARTS, ["v9"], onArc("v1")));
    expect(lines(program).slice(-2)).toEqual(["v11.next → v9.return", "v9.next → stop.in"]);
    expect(program.vertices.length).toBe(CARRIER.vertices.length);
  });

  it("refuses to move a vertex into itself", () => {
    expect(moveParts(CARRIER, PARTS, ["v1"], onArc("v13"))).toBeNull();
    expect(moveParts(CARRIER, PARTS, ["v9"], onArc("v9", "body"))).toBeNull();
  });

  it("does nothing when a vertex is dropped where it was", () => {
    expect(moveParts(CARRIER, PARTS, ["v13"], onArc("v13"))).toBeNull();
    expect(moveParts(CARRIER, PARTS, ["v13"], onArc("v11", "body"))).toBeNull();
  });

  it("copies with ids of their own", () => {
    const command = copyParts(CARRIER, PARTS, ["v4"], onArc("v1"));
    const program = after(CARRIER, command);
    expect(command?.selects).toEqual(["v21"]);
    expect(program.vertices.length).toBe(CARRIER.vertices.length + 3);
  });
});

describe("small commands", () => {
  it("toggleMark puts the mark on and off", () => {
    const marked = after(CARRIER, toggleMark(CARRIER, PARTS, "v13", "Interrupt"));
    expect(lines(marked)).toContain("v13.next → v21.action");
    expect(after(marked, toggleMark(marked, PARTS, "v13", "Interrupt"))).toEqual(CARRIER);
    expect(toggleMark(CARRIER, PARTS, "v5", "Interrupt")).toBeNull();
  });

  it("addBranch and removeBranch renumber ports and notes", () => {
    const noted = CARRIER.vertices.map((one) =>
      one.id === "v3" ? { ...one, notes: [{ text: "end", at: "in:branch.2" }] } : one,
    );
    const program = { ...CARRIER, vertices: noted };
    const less = after(program, removeBranch(program, PARTS, "v3", "branch.1"));
    expect(lines(less)).toContain("v3.branch.1 → v7.in");
    expect(less.vertices.find((one) => one.id === "v3")?.notes).toEqual([{ text: "end", at: "in:branch.1" }]);
    expect(removeBranch(less, PARTS, "v3", "branch.1")).toBeNull();
    expect(lines(after(less, addBranch(less, PARTS, "v3")))).toContain("v3.branch.2 → v3.return");
  });

  it("setField keeps a number that is out of range, for the server to name", () => {
    const program = after(CARRIER, setField(CARRIER, PARTS, "v8", "speed", "900"));
    expect(program.vertices.find((one) => one.id === "v8")?.settings).toEqual({ speed: "900" });
    expect(setField(CARRIER, PARTS, "v8", "speed", "50")).toBeNull();
  });

  it("setNote writes and takes away the note above", () => {
    const program = after(CARRIER, setNote(CARRIER, "v8", "slowly"));
    expect(noteText(program.vertices.find((one) => one.id === "v8")?.notes ?? [])).toBe("slowly");
    expect(after(program, setNote(program, "v8", ""))).toEqual(CARRIER);
  });

  it("replaceElement keeps parameters of the same name", () => {
    const program = after(CARRIER, replaceElement(CARRIER, PARTS, "v5", "Sign.LessThan"));
    expect(program.vertices.find((one) => one.id === "v5")).toMatchObject({
      element: "Sign.LessThan",
      settings: { value: "0" },
    });
    expect(replaceElement(CARRIER, PARTS, "v5", "Wheel.Stop")).toBeNull();
  });
});

describe("any edits", () => {
  it("leave no arc unreadable and the order canonical", () => {
    for (let seed = 1; seed <= 25; seed++) {
      const random = randomFrom(seed);
      let program = growProgram(seed, 20, true);
      for (let step = 0; step < 40; step++) {
        const command = randomEdit(random, program);
        if (command === null) continue;
        program = after(program, command);
        const structure = readStructure(program, PARTS);
        expect(structure.strays, `${command.label}, seed ${String(seed)}`).toEqual([]);
        expect(structure.main.closed).toBe(true);
        expect(new Set(program.vertices.map((one) => one.id)).size).toBe(program.vertices.length);
        expect(writeStructure(structure)).toEqual(program);
      }
    }
  });

  it("are undone to the former mission, and done again", () => {
    for (let seed = 1; seed <= 15; seed++) {
      const random = randomFrom(seed * 7919);
      useStudio.getState().openMission(fileOf(missionOf(growProgram(seed, 20, true), CARRIER)));
      const states = [structuredClone(useStudio.getState().mission)];
      for (let step = 0; step < 30; step++) {
        const { mission, execute } = useStudio.getState();
        const command = randomEdit(random, mission.programs[0] ?? CARRIER);
        if (command === null || command.joins !== undefined) continue;
        execute(command);
        states.push(structuredClone(useStudio.getState().mission));
      }
      const last = states.length - 1;
      for (let at = last - 1; at >= 0; at--) {
        useStudio.getState().undo();
        expect(useStudio.getState().mission).toEqual(states[at]);
      }
      expect(useStudio.getState()).toMatchObject({ canUndo: false, dirty: false });
      for (let at = 1; at <= last; at++) {
        useStudio.getState().redo();
        expect(useStudio.getState().mission).toEqual(states[at]);
      }
    }
  });
});
