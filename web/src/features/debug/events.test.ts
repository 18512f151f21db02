import { describe, expect, it } from "vitest";

import type { RunEvent } from "../../api/wire";
import { lastOf, withoutCause } from "./EventList";

const event = (tick: number, text = "", cause: RunEvent["cause"] = "program"): RunEvent => ({
  tick,
  kind: "failure",
  agent: "a",
  text,
  cause,
});

describe("what happened", () => {
  const events = [1, 2, 2, 5, 9].map((tick) => event(tick));

  it("is told up to the moment that the run stands at, the newest first", () => {
    expect(lastOf(events, 5, 9).map(({ tick }) => tick)).toEqual([5, 2, 2, 1]);
    expect(lastOf(events, Infinity, 2).map(({ tick }) => tick)).toEqual([9, 5]);
    expect(lastOf(events, 0, 9)).toEqual([]);
  });

  it("says its cause once", () => {
    expect(withoutCause(event(1, "fails (by chance)", "chance"))).toBe("fails");
    expect(withoutCause(event(1, "fault 1: a driver failed (Display)", "robot"))).toContain("(Display)");
    expect(withoutCause(event(1, "tombe en panne (à la main)", "person"))).toBe("tombe en panne");
    expect(withoutCause(event(1, "Dock = 3 (odd)", "program"))).toBe("Dock = 3 (odd)");
    expect(withoutCause(event(1, "Dock set by hand: 3", "person"))).toBe("Dock set by hand: 3");
  });
});
