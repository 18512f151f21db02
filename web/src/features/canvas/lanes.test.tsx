/** What a lane says of the robots that play in it, before and after a role changes hands. */
import { afterEach, expect, it } from "vitest";

import type { Member, RunEvent, RunMessage, TeamNow } from "../../api/generated";
import { applyMessage, useRun } from "../../session/run";
import { mount } from "../../testing/hooks";
import { Lane, playing } from "./Lanes";

const BEFORE = useRun.getState();
afterEach(() => useRun.setState(BEFORE, true));

function member(name: string, role: string, groups: string[] = [], stands_for = name): Member {
  return { name, role, groups, stands_for, missed: false };
}

function teamOf(...members: Member[]): TeamNow {
  return { members, groups: [...new Set(members.flatMap((one) => one.groups))], meetings: [] };
}

it("a lane says which robots play in it, and for whom one took over", () => {
  const team = teamOf(
    member("c-1", "carrier", ["movers"]),
    member("c-2", ""),
    member("c-3", "carrier", ["movers"], "c-2"),
    member("l-1", "loader"),
  );
  expect(playing(["movers"], team)).toBe("c-1, c-3 (c-2)");
  expect(playing(["loader", "c-1"], team)).toBe("c-1, l-1");
  expect(playing(["nobody"], team)).toBe("");
  expect(playing(["movers"], null)).toBe("");
});

it("what is meant for an agent is played by the one that stands for it, and by nobody who has no role", () => {
  const team = teamOf(member("c-1", "", [], "c-1"), member("c-2", "carrier", [], "c-1"), member("c-3", ""));
  expect(playing(["c-1"], team)).toBe("c-2 (c-1)");
  expect(playing(["c-2", "c-3"], team)).toBe("");
});

it("a role that robots moved out of is a group: its robots are those that are still in it", () => {
  const team = teamOf(member("c-1", "carrier", ["carrier"]), member("c-2", "carrier", ["movers"]));
  expect(playing(["carrier"], team)).toBe("c-1");
  const left = teamOf(member("c-1", "carrier", ["movers"]), member("c-2", "carrier", ["movers"]));
  expect(playing(["carrier"], { ...left, groups: ["carrier", "movers"] })).toBe("");
});

it("a lane says who plays there as soon as another robot takes a role over while it runs", () => {
  const news = (tick: number, team: TeamNow, events: RunEvent[] = []): RunMessage => ({
    type: "tick",
    tick,
    latest: tick,
    seconds: tick / 50,
    agents: {},
    stock: {},
    delivered: {},
    collisions: 0,
    events,
    again: false,
    team,
    drawing: null,
  });
  const take = (message: RunMessage) => useRun.setState((state) => applyMessage(state, message));
  const spare = member("c-2", "");
  take(news(1, teamOf(member("c-1", "carrier"), spare)));
  const { place, act, end } = mount(
    <Lane lane={{ id: "l", x: 0, y: 0, w: 10, h: 10, names: ["carrier"], first: true }} />,
  );
  const robots = () => place.querySelector(".lane-robots")?.textContent;
  expect(robots()).toBe("c-1");
  act(() => take(news(2, teamOf(member("c-1", ""), spare))));
  expect(robots()).toBeUndefined();
  act(() => take(news(3, teamOf(member("c-1", ""), member("c-2", "carrier", [], "c-1")))));
  expect(robots()).toBe("c-2 (c-1)");
  expect(place.querySelector(".lane-head")?.textContent).toBe("carrier c-2 (c-1)");
  end();
});
