import { describe, expect, it } from "vitest";

import type { RunEvent } from "../../api/wire";
import { axisFor, thinned, toldMarks } from "./EventStrip";

describe("the strip of events", () => {
  const event = (tick: number, kind: RunEvent["kind"]): RunEvent => ({
    tick,
    kind,
    agent: "a",
    text: "",
    cause: "program",
  });

  it("doubles its axis before the label of the moment leaves it", () => {
    expect(axisFor(0, 900).length).toBe(60);
    expect(axisFor(51, 900).length).toBe(60);
    expect(axisFor(52, 900).length).toBe(120);
    expect(axisFor(600, 900).length).toBe(960);
    // On a phone the label takes more of it.
    expect(axisFor(39, 300).length).toBe(60);
    expect(axisFor(40, 300).length).toBe(120);
    expect(axisFor(31, 100).length).toBe(120);
  });

  it("keeps the weightier of two events that would lie on each other", () => {
    const events = [event(8, "message"), event(11, "load"), event(50, "unload")];
    expect(thinned(events, (one) => one.tick, 9).map((one) => one.kind)).toEqual(["load", "unload"]);
  });
});

describe("the times on the axis", () => {
  it("never touch each other", () => {
    expect([600, 240, 239, 120, 119, 80, 79, 0].map(toldMarks)).toEqual([1, 1, 2, 2, 3, 3, 6, 6]);
  });
});
