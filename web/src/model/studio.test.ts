import { beforeEach, describe, expect, it } from "vitest";

import { deleteParts } from "./commands/deleteParts";
import { insertPart } from "./commands/insertPart";
import { setField } from "./commands/setField";
import { programInView, useStudio } from "./studio";
import { CARRIER, CARRIER_PARTS as PARTS, fileOf, missionOf } from "./testing/missions";

const studio = () => useStudio.getState();

beforeEach(() => {
  studio().openMission(fileOf(missionOf(CARRIER, { ...CARRIER, name: "second" })));
});

describe("the document", () => {
  it("selects what a command made and gives the selection back on undo", () => {
    studio().select(["v13"]);
    const command = insertPart(CARRIER, PARTS, { kind: "arc", source: "v13", out: "next" }, "Wheel.Stop");
    if (command !== null) studio().execute(command);
    expect(studio().selection).toEqual(["v21"]);
    studio().undo();
    expect(studio().selection).toEqual(["v13"]);
  });

  it("drops from the selection what was deleted", () => {
    studio().select(["v5", "v8"]);
    const command = deleteParts(CARRIER, PARTS, ["v4"]);
    if (command !== null) studio().execute({ ...command, selects: ["v5", "v8"] });
    expect(studio().selection).toEqual(["v8"]);
  });

  it("joins the steps of one drag of a slider into one undo", () => {
    for (const value of ["51", "52", "53"]) {
      const program = programInView(studio());
      const command = program === undefined ? null : setField(program, PARTS, "v8", "speed", value);
      if (command !== null) studio().execute(command);
    }
    studio().undo();
    expect(programInView(studio())).toEqual(CARRIER);
    expect(studio().canUndo).toBe(false);
    studio().redo();
    expect(programInView(studio())?.vertices.find((one) => one.id === "v8")?.settings["speed"]).toBe("53");
  });

  it("is dirty exactly while it differs from what was saved", () => {
    const edit = () => {
      const program = programInView(studio());
      const command = program === undefined ? null : deleteParts(program, PARTS, ["v13"]);
      if (command !== null) studio().execute(command);
    };
    edit();
    expect(studio().dirty).toBe(true);
    studio().markSaved("a/b.krt", "2");
    expect(studio()).toMatchObject({ dirty: false, file: { path: "a/b.krt", name: "b.krt", revision: "2" } });
    studio().undo();
    expect(studio().dirty).toBe(true);
    studio().redo();
    expect(studio().dirty).toBe(false);
    studio().undo();
    const program = programInView(studio());
    const other = program === undefined ? null : deleteParts(program, PARTS, ["v6"]);
    if (other !== null) studio().execute(other);
    expect(studio().dirty).toBe(true);
  });

  it("stays dirty when it changed while it was being written", () => {
    const { mission } = studio();
    const command = deleteParts(CARRIER, PARTS, ["v13"]);
    if (command !== null) studio().execute(command);
    studio().markSaved("a.krt", "2", "a.krt", mission);
    expect(studio().dirty).toBe(true);
  });

  it("goes back to the program in which a command was done", () => {
    const command = deleteParts(CARRIER, PARTS, ["v13"]);
    if (command !== null) studio().execute(command);
    studio().setActiveProgram("second");
    studio().undo();
    expect(studio().activeProgram).toBe("carrier");
  });

  it("ignores a program or a vertex that is not there", () => {
    studio().setActiveProgram("third");
    studio().select(["v99"]);
    expect(studio()).toMatchObject({ activeProgram: "carrier", selection: [] });
    studio().undo();
    studio().redo();
    expect(studio().canUndo).toBe(false);
  });
});
