import { describe, expect, it } from "vitest";

import { CARRIER, missionOf } from "../testing/missions";
import type { Mission } from "../types";
import { addAgent, copyAgent, giveStart, moveAgent, placeAgents, removeAgent, renameAgent } from "./changeAgents";
import { addGoal, changeGoal } from "./changeGoals";
import { changeTitle } from "./changeTitle";
import { changeWorld } from "./changeWorld";

const MISSION: Mission = {
  ...missionOf(CARRIER),
  agents: [
    { name: "a", program: "carrier", start: "" },
    { name: "b", program: "carrier", start: "dock" },
  ],
  breakpoints: [
    { program: "carrier", vertex: "v1", agents: ["a"] },
    { program: "carrier", vertex: "v2", agents: ["a", "b"] },
  ],
  failures: [{ agent: "a", at_s: 2, kind: "fail" }],
};

describe("agents", () => {
  it("keep their place when they are renamed, and breakpoints and failures follow", () => {
    const after = renameAgent(MISSION, 0, "first")?.execute(MISSION);
    expect(after?.agents[0]).toEqual({ name: "first", program: "carrier", start: "a" });
    expect(after?.breakpoints?.map((one) => one.agents)).toEqual([["first"], ["first", "b"]]);
    expect(after?.failures?.[0]?.agent).toBe("first");
  });

  it("say a start of their own name in the shortest way", () => {
    expect(renameAgent(MISSION, 1, "dock")?.execute(MISSION).agents[1]?.start).toBe("");
    expect(giveStart(MISSION, 1, "b")?.execute(MISSION).agents[1]?.start).toBe("");
    expect(addAgent(MISSION, "c", "carrier", "c")?.execute(MISSION).agents[2]?.start).toBe("");
  });

  it("take what was only for them along when they go", () => {
    const after = removeAgent(MISSION, 0)?.execute(MISSION);
    expect(after?.breakpoints?.map((one) => one.agents)).toEqual([["b"]]);
    expect(after !== undefined && "failures" in after).toBe(false);
  });

  it("have names of their own", () => {
    expect(addAgent(MISSION, "a", "carrier", "")).toBeNull();
    expect(addAgent(MISSION, "", "carrier", "")).toBeNull();
    expect(renameAgent(MISSION, 0, "b")).toBeNull();
    expect(copyAgent(MISSION, 0, "b", "x")).toBeNull();
  });

  it("move within the list and no further", () => {
    expect(
      moveAgent(MISSION, 0, 1)
        ?.execute(MISSION)
        .agents.map((one) => one.name),
    ).toEqual(["b", "a"]);
    expect(moveAgent(MISSION, 1, 2)).toBeNull();
    expect(moveAgent(MISSION, 0, -1)).toBeNull();
  });

  it("are put on starts where nobody is", () => {
    const after = placeAgents(MISSION, ["dock", "gate"])?.execute(MISSION);
    expect(after?.agents.map((one) => one.start)).toEqual(["gate", "dock"]);
    expect(placeAgents(MISSION, ["a", "dock"])).toBeNull();
  });
});

describe("goals, world and title", () => {
  it("change only when they change", () => {
    const mission = addGoal(MISSION, "B")?.execute(MISSION) ?? MISSION;
    expect(mission.goals).toEqual([{ storehouse: "B", stock: "all" }]);
    expect(changeGoal(mission, 0, { storehouse: "B", stock: "all" })).toBeNull();
    expect(changeWorld(MISSION, "empty.world.xml")).toBeNull();
    expect(changeTitle(MISSION, "label", "", "")).toBeNull();
  });

  it("leave a title out that nobody wrote", () => {
    const titled = changeTitle(MISSION, "label", "ur", "میرا\u0000\nمشن")?.execute(MISSION) ?? MISSION;
    expect(titled.label).toEqual({ ur: "میرا مشن" });
    const plain = changeTitle(titled, "label", "ur", "")?.execute(titled) ?? titled;
    expect("label" in plain).toBe(false);
  });
});
