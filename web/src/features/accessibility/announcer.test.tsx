/** What a screen reader hears while a team runs. */
import { afterEach, beforeEach, describe, expect, it } from "vitest";

import type { RunEvent, RunMessage, TeamNow } from "../../api/generated";
import { applyMessage, useRun } from "../../session/run";
import { mount, type Mounted } from "../../testing/hooks";
import { Announcer } from "./Announcer";

const BEFORE = useRun.getState();
const TEAM: TeamNow = { members: [], groups: [], meetings: [] };
let page: Mounted;
beforeEach(() => {
  page = mount(<Announcer />);
});
afterEach(() => {
  page.end();
  useRun.setState(BEFORE, true);
});

function event(tick: number, agent: string, text: string, kind: RunEvent["kind"] = "member"): RunEvent {
  return { tick, kind, agent, text, cause: "program" };
}

/** A message of the server comes: of a tick, or of another moment (`again`) with all events until there. */
function comes(events: RunEvent[], again = false, team: TeamNow | null = TEAM): void {
  const tick = events.at(-1)?.tick ?? 0;
  const message: RunMessage = {
    type: "tick",
    tick,
    latest: tick,
    seconds: 0,
    agents: {},
    stock: {},
    delivered: {},
    collisions: 0,
    events,
    again,
    team,
    drawing: null,
  };
  page.act(() => useRun.setState((state) => applyMessage(state, message)));
}

const live = () => page.place.querySelector('[aria-live="polite"]');
const heard = () => live()?.textContent.trim();
const FAILS = event(5, "carrier-2", "fails", "failure");
const MISSED = event(55, "carrier-2", "is missed by its team");
const TAKEN = event(55, "carrier-4", "takes over for `carrier-2`");

describe("while a team runs", () => {
  it("says that a robot fails, and which one takes its role over", () => {
    comes([FAILS]);
    expect(heard()).toBe("carrier-2 fails");
    comes([MISSED, TAKEN]);
    expect(heard()).toBe("carrier-2 is missed by its team; carrier-4 takes over for carrier-2");
  });

  it("says each change once, the same words as another text when they come again", () => {
    comes([TAKEN]);
    const first = live()?.textContent;
    comes([]);
    expect(live()?.textContent).toBe(first);
    comes([event(90, TAKEN.agent, TAKEN.text)]);
    expect(live()?.textContent).not.toBe(first);
    expect(heard()).toBe("carrier-4 takes over for carrier-2");
  });

  it("is silent about messages and boxes, and of many changes at once says the last three", () => {
    comes([event(1, "a", "a box from A", "load"), event(1, "a", "Run = true", "message")]);
    expect(heard()).toBe("");
    comes([1, 2, 3, 4, 5].map((n) => event(2, `c-${String(n)}`, "goes over to movers")));
    expect(heard()).toBe("c-3 goes over to movers; c-4 goes over to movers; c-5 goes over to movers");
  });

  it("says nothing when somebody goes back to a moment, and goes on from there", () => {
    comes([FAILS]);
    comes([MISSED, TAKEN]);
    const before = live()?.textContent;
    comes([{ ...FAILS }], true);
    expect(live()?.textContent).toBe(before);
    comes([{ ...MISSED }]);
    expect(heard()).toBe("carrier-2 is missed by its team");
  });
});

it("a run without a team's program is silent", () => {
  comes([FAILS], false, null);
  expect(heard()).toBe("");
});
