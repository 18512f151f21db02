/** A selection is replaced by a part, a part changes its vertices, and its instructions take their place again. */
import { describe, expect, it } from "vitest";

import type { Command } from "../command";
import { catalogueOf } from "../own-parts";
import { partsOf } from "../parts";
import { readStructure } from "../structure";
import { CARRIER, missionOf } from "../testing/missions";
import { PARTS } from "../testing/parts";
import { everySpot } from "../tree";
import type { Arc, Constructor, Mission, Program, Slot, Vertex } from "../types";
import { addConstructor, removeConstructor } from "./changeOwn";
import { changePart, dissolvePart, saveAsPart } from "./ownParts";

const MISSION = missionOf(CARRIER);

function slot(name: string, kind: Slot["kind"], more: Partial<Slot> = {}): Slot {
  const rest = { label: {}, loop: false, repeat: false, least: 0, min: null, max: null, default: "", unit: "" };
  return { ...rest, name, kind, ...more };
}

function own(slots: Slot[], code: string): Constructor {
  const rest = { group: "Own", icon: "", colour: "action", label: {}, help: {}, role: "instruction" } as const;
  return { ...rest, name: "Own", adds: null, slots, code };
}

const PART = own(
  [slot("n", "number", { default: "3" }), slot("c", "condition"), slot("body", "flow")],
  "{n}*( *[{c}]({body}); Wheel.Stop(); )",
);

const vertex = (id: string, element: string, settings: Record<string, string> = {}): Vertex => ({
  id,
  element,
  settings,
  notes: [],
});
const arc = (source: string, target: string, out = "next", at = "in"): Arc => ({ source, target, out, at });

const USE: Program = {
  name: "carrier",
  robot: "carrier",
  vertices: [
    vertex("start", "Start"),
    {
      ...vertex("v1", "Own", { n: "7" }),
      notes: [
        { text: "why", at: "" },
        { text: "end", at: "in:body" },
      ],
    },
    vertex("v2", "Run.IsTrue"),
    vertex("v3", "Own", { n: "2" }),
    vertex("v4", "Lamp.LightOn"),
    vertex("stop", "Stop"),
  ],
  arcs: [
    arc("start", "v1"),
    arc("v2", "v1", "next", "c"),
    arc("v1", "v3", "body"),
    arc("v3", "v4", "body"),
    arc("v4", "v3", "next", "return"),
    arc("v3", "v1", "next", "return"),
    arc("v1", "stop"),
  ],
};

/** The part's template, as the server draws it. */
const DRAWING: Program = {
  name: "Own",
  robot: "carrier",
  vertices: [
    vertex("start", "Start"),
    vertex("v1", "Repetition", { count: "{n}" }),
    vertex("v2", "While"),
    vertex("v3", "{c}"),
    vertex("v4", "{body}"),
    vertex("v5", "Wheel.Stop"),
    vertex("stop", "Stop"),
  ],
  arcs: [
    arc("start", "v1"),
    arc("v1", "v2", "body"),
    arc("v3", "v2", "next", "condition"),
    arc("v2", "v4", "body"),
    arc("v4", "v2", "next", "return"),
    arc("v2", "v5"),
    arc("v5", "v1", "next", "return"),
    arc("v1", "stop"),
  ],
};

const USING: Mission = { ...MISSION, programs: [USE], constructors: [PART] };

function said(mission: Mission): string[] {
  const [program] = mission.programs;
  if (program === undefined) return [];
  const lines: string[] = [];
  everySpot(readStructure(program, partsOf(catalogueOf(PARTS, mission), "carrier")), ({ block }) => {
    const settings = Object.values(block.vertex.settings).join(" ");
    lines.push(`${block.vertex.element} ${settings}`.trim());
  });
  return lines;
}

describe("a selection becomes a part", () => {
  it("adds the part and its vertex in one step", () => {
    const mission = { ...MISSION, programs: [CARRIER] };
    const command = saveAsPart(mission, PART, { program: { ...USE, name: "carrier" }, vertex: "v1" });
    const after = command?.execute(mission);
    expect(after?.constructors).toEqual([PART]);
    expect(after?.programs[0]?.vertices).toBe(USE.vertices);
    expect(command?.selects).toEqual(["v1"]);
  });

  it("leaves the program where the part is only kept", () => {
    const command = saveAsPart(MISSION, PART, null);
    expect(command?.execute(MISSION).programs).toBe(MISSION.programs);
  });

  it("is none under a name that is taken", () => {
    expect(saveAsPart(USING, PART, null)).toBeNull();
  });
});

describe("a part is changed", () => {
  it("touches no program where its slots stay", () => {
    const after = changePart(USING, PARTS, "Own", { ...PART, icon: "zap" })?.execute(USING);
    expect(after?.programs[0]).toBe(USE);
  });

  it("renames its vertices, gives new slots their defaults, parks what stood in slots that are gone", () => {
    const made = { ...own([slot("n", "number"), slot("m", "number", { default: "9" })], ""), name: "Other" };
    const command = changePart(USING, PARTS, "Own", made);
    const after = command?.execute(USING) ?? USING;
    expect(said(after)).toEqual(["Other 7 9", "Run.IsTrue", "Other 2 9", "Lamp.LightOn"]);
    expect(after.programs[0]?.vertices.find(({ id }) => id === "v1")?.notes.map(({ at }) => at)).toEqual(["", ""]);
  });

  it("closes a body that is new", () => {
    const more = own([...PART.slots, slot("more", "flow")], "");
    const after = changePart(USING, PARTS, "Own", more)?.execute(USING);
    expect(after?.programs[0]?.arcs).toContainEqual(arc("v3", "v3", "more", "return"));
  });

  it("is no change under a name that another part has", () => {
    const two = addConstructor(USING, { ...PART, name: "Two" })?.execute(USING) ?? USING;
    expect(changePart(two, PARTS, "Own", { ...PART, name: "Two" })).toBeNull();
  });
});

describe("a part's instructions take its place", () => {
  it("fills in what each vertex was given, one in the other too", () => {
    const command = dissolvePart(USING, PARTS, "Own", new Map([["carrier", DRAWING]]));
    const after = command?.execute(USING) ?? USING;
    expect(after.constructors).toBeUndefined();
    expect(said(after)).toEqual([
      "Repetition 7",
      "While",
      "Run.IsTrue",
      "Repetition 2",
      "While",
      "Lamp.LightOn",
      "Wheel.Stop",
      "Wheel.Stop",
    ]);
    const notes = after.programs[0]?.vertices.flatMap((one) =>
      one.notes.map(({ at, text }) => [one.element, at, text]),
    );
    expect(notes).toEqual([
      ["Repetition", "", "why"],
      ["While", "in:body", "end"],
    ]);
  });

  it("needs a drawing for each robot that uses it", () => {
    expect(dissolvePart(USING, PARTS, "Own", new Map())).toBeNull();
    expect(dissolvePart(USING, PARTS, "Nobody", new Map())).toBeNull();
  });
});

describe("any changes of parts in a row", () => {
  /** Numbers that look random, the same for the same seed. */
  function dice(seed: number): (sides: number) => number {
    let state = seed * 2654435761 + 1;
    return (sides) => {
      state = (Math.imul(state, 1103515245) + 12345) >>> 0;
      return Math.floor((state / 2 ** 32) * sides);
    };
  }

  function change(mission: Mission, roll: (sides: number) => number): Command | null {
    const names = (mission.constructors ?? []).map(({ name }) => name);
    const name = names[roll(Math.max(1, names.length))] ?? "";
    const slots = PART.slots.filter(() => roll(3) > 0);
    const made = {
      ...own([...slots, ...(roll(2) > 0 ? [slot("more", "flow")] : [])], ""),
      name: `P${String(roll(4))}`,
    };
    switch (roll(4)) {
      case 0:
        return saveAsPart(mission, made, null);
      case 1:
        return changePart(mission, PARTS, name, made);
      case 2:
        return dissolvePart(mission, PARTS, name, new Map([["carrier", DRAWING]]));
      default:
        return removeConstructor(mission, name);
    }
  }

  it("lose no vertex that a person drew, and leave the mission before as it was", () => {
    for (let seed = 0; seed < 60; seed++) {
      const roll = dice(seed);
      let mission: Mission = USING;
      for (let step = 0; step < 12; step++) {
        const [before, text] = [mission, JSON.stringify(mission)];
        mission = change(before, roll)?.execute(before) ?? before;
        expect(JSON.stringify(before)).toBe(text);
        const elements = mission.programs[0]?.vertices.map(({ element }) => element) ?? [];
        expect(elements).toEqual(expect.arrayContaining(["Start", "Run.IsTrue", "Lamp.LightOn", "Stop"]));
      }
    }
  });
});
