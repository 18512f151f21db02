import { afterEach, describe, expect, it, vi } from "vitest";

import { freeName } from "../model/free-name";
import type { Mission, World } from "../model/types";
import { nextSpeed, programWithAgent, run } from "./actions";
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
    const made = programWithAgent(MISSION, "mini-robot", worldWith("r-1", "r-2"));
    const after = made?.command.execute(MISSION);
    expect(made?.name).toBe("program-2");
    expect(after?.agents.at(-1)).toEqual({ name: "r-2", program: "program-2", start: "" });
  });

  it("comes alone where the world has no place left", () => {
    const made = programWithAgent(MISSION, "mini-robot", worldWith("r-1"));
    expect(made?.command.execute(MISSION).agents).toEqual(MISSION.agents);
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
