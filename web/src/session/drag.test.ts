import type { PointerEvent as ReactPointerEvent } from "react";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { useStudio } from "../model/studio";
import { CARRIER, fileOf, missionOf } from "../model/testing/missions";
import { beginDrag, type Payload, setBin, setResolver, useDrag } from "./drag";
import { target } from "./targets";

const BIN = { left: 0, top: 0, right: 200, bottom: 600, width: 200 } as DOMRect;
const VERTICES: Payload = { kind: "vertices", ids: ["v6"], element: "Lamp.LightOn" };
const IN_GRAPH = [400, 300] as const;
const IN_BIN = [60, 300] as const;

function send(name: string, [x, y]: readonly [number, number]): void {
  window.dispatchEvent(new PointerEvent(name, { pointerId: 1, clientX: x, clientY: y, bubbles: true }));
}

/** A mouse that takes it at a place and goes to another one. */
function drag(payload: Payload, from: readonly [number, number], to: readonly [number, number]): void {
  const [clientX, clientY] = from;
  const currentTarget = document.body;
  const down = { button: 0, isPrimary: true, pointerId: 1, pointerType: "mouse", clientX, clientY, currentTarget };
  beginDrag(down as unknown as ReactPointerEvent, payload);
  send("pointermove", to);
}

const isThere = (id: string) => useStudio.getState().mission.programs[0]?.vertices.some((one) => one.id === id);

beforeEach(() => {
  useStudio.getState().openMission(fileOf(missionOf(CARRIER)));
  const bin = document.createElement("div");
  vi.spyOn(bin, "getBoundingClientRect").mockReturnValue(BIN);
  setBin(bin);
  setResolver(() => target({ kind: "void" }));
});
afterEach(() => {
  setBin(null);
  setResolver(() => null);
});

describe("what is dropped on the list of parts", () => {
  it("is thrown away, by one step that can be taken back", () => {
    drag(VERTICES, IN_GRAPH, IN_BIN);
    expect(useDrag.getState()).toMatchObject({ away: true, target: null });
    send("pointerup", IN_BIN);
    expect([isThere("v6"), useDrag.getState().away]).toEqual([false, false]);
    useStudio.getState().undo();
    expect(isThere("v6")).toBe(true);
  });

  it("stays when it leaves again, or the drag is given up", () => {
    drag(VERTICES, IN_GRAPH, IN_BIN);
    send("pointermove", IN_GRAPH);
    expect(useDrag.getState()).toMatchObject({ away: false, target: { key: "void" } });
    send("pointermove", IN_BIN);
    send("pointercancel", IN_BIN);
    expect([isThere("v6"), useDrag.getState().payload]).toEqual([true, null]);
  });

  it("is nothing where it came from there", () => {
    const before = useStudio.getState().mission;
    setResolver(() => null);
    drag({ kind: "part", element: "Wait" }, IN_BIN, [90, 400]);
    expect(useDrag.getState().away).toBe(false);
    send("pointerup", [90, 400]);
    expect(useStudio.getState().mission).toBe(before);
  });

  it("is not thrown away where the list is not seen", () => {
    setBin(document.createElement("div"));
    drag(VERTICES, IN_GRAPH, [0, 0]);
    expect(useDrag.getState().away).toBe(false);
    send("pointercancel", [0, 0]);
  });
});
