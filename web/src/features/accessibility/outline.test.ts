import { describe, expect, it } from "vitest";

import { readStructure } from "../../model/structure";
import { useStudio } from "../../model/studio";
import { CARRIER, CARRIER_PARTS, fileOf, missionOf } from "../../model/testing/missions";
import { changeWords } from "./Announcer";
import { outlineOf, rowAbove } from "./outline";

const rows = outlineOf(readStructure(CARRIER, CARRIER_PARTS));
const drawn = rows.map(({ level, words }) => `${"  ".repeat(level - 1)}${words}`);

describe("the outline", () => {
  it("has a row for each vertex of a chain, told as on the graph", () => {
    expect(drawn).toMatchInlineSnapshot(`
      [
        "Start",
        "While, Run is true",
        "  Parallelism",
        "    branch 1",
        "      When, Sign = 0",
        "        Lamp LightOn",
        "    branch 2",
        "      Wheel Advance, speed 50 %, Interruptible",
        "      While, Run is true",
        "        When, Collision pressed",
        "          Wheel Stop",
        "          When, Collision released",
        "            Wheel Advance, speed 50 %, Interruptible",
        "  When, Cargo pressed",
        "    Lamp LightOff",
        "End",
      ]
    `);
  });

  it("stands for the action where a mark holds one", () => {
    expect(rows.find((row) => row.key === "v7")?.vertex).toBe("v8");
  });

  it("leads outwards to the row that holds this one", () => {
    const at = rows.findIndex((row) => row.key === "v4");
    expect(rows[rowAbove(rows, at)]?.key).toBe("v3 branch.1");
    expect(rowAbove(rows, 0)).toBe(-1);
  });
});

describe("announcements", () => {
  it("say what was done, undone and done again, and nothing of opening", () => {
    const { openMission, execute, undo, redo } = useStudio.getState();
    const mission = missionOf(CARRIER);
    const said: string[] = [];
    const off = useStudio.subscribe((state, before) => {
      if (state.change !== before.change) said.push(changeWords(state));
    });
    openMission(fileOf(mission));
    execute({ label: "Add Wait", execute: (before) => ({ ...before }) });
    undo();
    redo();
    off();
    expect(said).toEqual(["", "Add Wait", "Undone: Add Wait", "Done again: Add Wait"]);
  });
});
