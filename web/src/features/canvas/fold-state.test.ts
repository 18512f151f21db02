import { beforeEach, describe, expect, it } from "vitest";

import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { currentDrawing } from "../../session/drawing";
import { foldedIn } from "../../session/folds";
import { toggleFold, toggleFoldOfSelection } from "./fold-state";

const shown = () => currentDrawing()?.layout.nodes.map((node) => node.id) ?? [];

beforeEach(() => {
  useStudio.getState().openMission(fileOf(missionOf(CARRIER)));
});

describe("folding", () => {
  it("hides what stands inside, and tells how many parts it is", () => {
    expect(toggleFold("v9")).toBe(true);
    expect(shown()).not.toContain("v11");
    expect(currentDrawing()?.nodes.get("v9")?.inside).toMatchObject({ count: 4 });
    expect(currentDrawing()?.nodes.get("v9")?.inside?.vertices).toContain("v17");
    expect(currentDrawing()?.layout.frames.map((frame) => frame.id)).not.toContain("v9");
    toggleFold("v9");
    expect(shown()).toContain("v11");
  });

  it("moves the selection out, and changes neither the mission nor its history", () => {
    const { mission } = useStudio.getState();
    useStudio.getState().select(["v13"]);
    toggleFold("v9");
    expect(useStudio.getState().selection).toEqual(["v9"]);
    expect(useStudio.getState()).toMatchObject({ mission, canUndo: false, dirty: false });
  });

  it("of everything makes the program short", () => {
    const before = currentDrawing()?.layout.bounds.h ?? 0;
    toggleFold("v1");
    expect(shown()).toEqual(["start", "v1", "stop"]);
    expect(currentDrawing()?.layout.bounds.h).toBeLessThan(before / 3);
  });

  it("opens for what is selected inside", () => {
    toggleFold("v11");
    toggleFold("v1");
    useStudio.getState().select(["v13"]);
    expect(foldedIn("carrier").size).toBe(0);
    expect(shown()).toContain("v13");
  });

  it("by key takes the selected constructor, or the one around the selected part", () => {
    expect(toggleFoldOfSelection()).toBe(false);
    useStudio.getState().select(["v13"]);
    expect(toggleFoldOfSelection()).toBe(true);
    expect([...foldedIn("carrier")]).toEqual(["v11"]);
    toggleFoldOfSelection();
    expect(foldedIn("carrier").size).toBe(0);
  });

  it("is nothing for what holds no chain, and is forgotten with another mission", () => {
    expect(toggleFold("v6")).toBe(false);
    expect(toggleFold("start")).toBe(false);
    toggleFold("v9");
    useStudio.getState().openMission(fileOf(missionOf(CARRIER)));
    expect(shown()).toContain("v11");
  });
});
