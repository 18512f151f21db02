import { afterEach, describe, expect, it, vi } from "vitest";

import { emptyProgram } from "../model/commands/changePrograms";
import { freeName } from "../model/free-name";
import { fileOf } from "../model/testing/missions";
import { useStudio } from "../model/studio";
import type { Mission, World } from "../model/types";
import { addProgramFor, nextSpeed, programWithAgent, run } from "./actions";
import { useDocument } from "./document";
import { useRun } from "./run";

const MISSION: Mission = {
  version: 1,
  programs: [{ name: "program-1", robot: "r", vertices: [], arcs: [] }],
  agents: [{ name: "r-1", program: "program-1", start: "" }],
  goals: [],
  world: "",
};

function worldWith(...starts: string[]): World {
  const lists = { walls: [], floors: [], lines: [], roads: [], docks: [], storehouses: [] };
  const at = { x_mm: 0, y_mm: 0, heading_rad: 0 };
  return { name: "w", width_mm: 1, height_mm: 1, ...lists, starts: starts.map((name) => ({ name, ...at })) };
}

describe("a new program", () => {
  it("brings an agent that runs it", () => {
    const made = programWithAgent(MISSION, emptyProgram("program-2", "mini-robot"), worldWith("r-1", "r-2"));
    const after = made?.execute(MISSION);
    expect(after?.agents.at(-1)).toEqual({ name: "r-2", program: "program-2", start: "" });
  });

  it("comes alone where the world has no place left", () => {
    const made = programWithAgent(MISSION, emptyProgram("program-2", "mini-robot"), worldWith("r-1"));
    expect(made?.execute(MISSION).agents).toEqual(MISSION.agents);
  });

  it("whose world has no place left can be run by the agent of the program that was in view", async () => {
    useStudio.getState().openMission(fileOf({ ...MISSION, world: "" }));
    addProgramFor("r");
    const { banner } = useDocument.getState();
    expect(banner?.actions.map((action) => action.label)).toEqual(["Let r-1 run program-2", "Open the team"]);
    banner?.actions[0]?.run();
    await vi.waitFor(() => expect(useStudio.getState().mission.agents[0]?.program).toBe("program-2"));
    expect(useDocument.getState().banner).toBeNull();
    addProgramFor("another robot");
    expect(useDocument.getState().banner?.actions.map((action) => action.label)).toEqual(["Open the team"]);
  });

  it("takes the first name that is free", () => {
    expect(freeName("a", ["a-1", "a-3"])).toBe("a-2");
  });
});

describe("Run", () => {
  const begun = useRun.getState();
  afterEach(() => {
    useRun.setState(begun);
    useDocument.setState({ ready: false });
  });

  it("that is pressed before the first mission is there starts it once when it is", async () => {
    const start = vi.fn(() => useRun.setState({ status: "connecting" }));
    useRun.setState({ status: "idle", start });
    useDocument.setState({ ready: false, overlay: null });
    run();
    run();
    expect(start).not.toHaveBeenCalled();
    useDocument.setState({ ready: true });
    await vi.waitFor(() => expect(start).toHaveBeenCalledOnce());
  });
});

describe("the speed", () => {
  it("steps through its notches and stops at the ends", () => {
    expect([nextSpeed(1, 1), nextSpeed(1, -1), nextSpeed(3, 1), nextSpeed(3, -1)]).toEqual([2, 0.5, 5, 2]);
    expect([nextSpeed(100, 1), nextSpeed(0, 1), nextSpeed(0, -1), nextSpeed(0.1, -1)]).toEqual([0, 0, 100, 0.1]);
  });
});
