import { describe, expect, it } from "vitest";

import { CARRIER_PARTS as PARTS } from "../../model/testing/missions";
import { matches, rowsOf } from "./tree";

const labels = (query: string, folded = {}) => rowsOf(PARTS, query, folded).map((row) => row.label);

describe("the palette's rows", () => {
  it("come from the catalogue: groups, then the robot's objects, the first one open", () => {
    const rows = labels("");
    expect(rows.slice(0, 5)).toEqual(["Control", "Loops", "Repetition", "While", "Break"]);
    expect(rows.slice(rows.indexOf("Robot"), rows.indexOf("Robot") + 6)).toEqual([
      "Robot",
      "Actions",
      "Wheel",
      "Advance",
      "Reverse",
      "Stop",
    ]);
    expect(rows).not.toContain("LightOn");
  });

  it("name what is in a folded group", () => {
    const fold = rowsOf(PARTS, "", {}).find((row) => row.label === "Conditions");
    expect(fold).toMatchObject({ kind: "fold", open: false, aside: "And · Or · No" });
  });

  it("say a method's parameters beside it", () => {
    expect(rowsOf(PARTS, "", {}).find((row) => row.label === "Advance")).toMatchObject({ aside: "speed" });
  });

  it("fold and unfold", () => {
    expect(labels("", { "group Loops": true })).not.toContain("While");
    expect(labels("", { "object actuator Lamp": false })).toContain("LightOn");
    expect(labels("", { "section sensor": true })).not.toContain("Sign");
  });

  it("are what matches while one searches, all open", () => {
    expect(labels("light")).toEqual(["Robot", "Actions", "Lamp", "LightOn", "LightOff"]);
    expect(labels("xyz")).toEqual([]);
  });
});

describe("matches", () => {
  it("takes words in any order and case", () => {
    expect(matches(PARTS.shape("Wheel.Advance"), "adv wheel")).toBe(true);
    expect(matches(PARTS.shape("Wheel.Advance"), "adv lamp")).toBe(false);
  });
});
