/** The watch sets variables and forces sensors; numbers that cannot be are not taken; what happened can be gone to. */
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { moreWords } from "../../i18n/words";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { useStudio } from "../../model/studio";
import { useRun } from "../../session/run";
import type { RunAgent } from "../../session/run-state";
import { furnish } from "../../testing/graph";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted } from "../../testing/hooks";
import { WatchPanel } from "./Watch";

const agent = (forced: string[] = [], sign = 3) =>
  ({
    ...{ name: "c-1", program: "carrier", robot: "carrier", number: 1, kind: "carrier", active: [], state: "running" },
    ...{ inputs: { Sign: sign, Cargo: 0 }, values: { Count: 0, Run: 1 }, fault: 0, forced, shown: {}, placed: true },
  }) as unknown as RunAgent;

let page: Mounted;
let hands: Hands;
const [force, setVariable, seek] = [vi.fn(), vi.fn(), vi.fn()];
const field = (name: string) => hands.find(`watch-${name}`).querySelector<HTMLInputElement>("input, select")!;

beforeEach(async () => {
  furnish();
  await moreWords();
  useStudio.getState().openMission(fileOf(missionOf(CARRIER)));
  useRun.setState({
    ...{ status: "paused", tick: 50, latest: 50, tickMs: 20, abilities: ["force", "set", "seek"] as const },
    ...{ force, setVariable, seek, agents: [agent()] },
  });
  page = mount(<WatchPanel />);
  hands = handsOn(page);
});
afterEach(() => {
  page.end();
  for (const one of [force, setVariable, seek]) one.mockClear();
  useRun.setState(useRun.getInitialState());
});

function type(name: string, text: string): void {
  page.act(() => field(name).focus());
  page.act(() => {
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(field(name), text);
    field(name).dispatchEvent(new Event("input", { bubbles: true }));
  });
  page.act(() => field(name).dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true })));
}

describe("a value", () => {
  it("of a variable is set, of a sensor held; out of the range, or none, it is not taken", () => {
    type("Count", "42");
    expect(setVariable.mock.lastCall).toEqual(["c-1", "Count", 42]);
    for (const wrong of ["101", "-1", "many", "1.5", ""]) type("Count", wrong);
    expect([setVariable.mock.calls.length, field("Count").value]).toEqual([1, "0"]);
    type("Sign", "7");
    expect(force.mock.lastCall).toEqual(["c-1", "Sign", 7]);
  });

  it("of a switch is chosen", () => {
    hands.find("watch-Run");
    page.act(() => {
      Object.getOwnPropertyDescriptor(HTMLSelectElement.prototype, "value")?.set?.call(field("Run"), "0");
      field("Run").dispatchEvent(new Event("change", { bubbles: true }));
    });
    expect(setVariable.mock.lastCall).toEqual(["c-1", "Run", 0]);
  });

  it("that is held says so and is let go by its button, which has its room before", () => {
    expect([hands.has("release-Sign"), hands.find("watch-Sign").querySelector(".is-room")]).toEqual([
      false,
      expect.anything(),
    ]);
    page.act(() => useRun.setState({ agents: [agent(["Sign"], 7)] }));
    expect([hands.find("watch-Sign").dataset["forced"], field("Sign").value]).toEqual(["true", "7"]);
    hands.click("release-Sign");
    expect(force.mock.lastCall).toEqual(["c-1", "Sign", null]);
  });

  it("cannot be set in a run of somebody else", () => {
    page.act(() => useRun.setState({ abilities: [] }));
    expect([field("Sign").disabled, field("Count").disabled]).toEqual([true, true]);
  });
});

it("what happened stands with who brought it about, and its moment can be gone to", () => {
  const happened = {
    tick: 40,
    kind: "failure" as const,
    agent: "c-1",
    text: "loses its radio (by hand)",
    cause: "person" as const,
  };
  page.act(() => useRun.setState({ events: [happened] }));
  const row = hands.find("event-list").querySelector<HTMLElement>("tbody tr")!;
  expect([row.dataset["cause"], row.querySelector("td:last-child")?.textContent]).toEqual(["person", "by hand"]);
  expect(row.textContent).not.toContain("(");
  page.act(() => row.querySelector("button")?.click());
  expect(seek).toHaveBeenCalledWith(40);
});
