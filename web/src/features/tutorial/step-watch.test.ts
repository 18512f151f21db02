/** What a run says in the words of tutorials. */
import { describe, expect, it } from "vitest";

import type { Member, Meeting, RunEvent } from "../../api/generated";
import { eventsOf, eventsOfTeam } from "./step-watch";

function member(name: string, more: Partial<Member> = {}): Member {
  return { name, role: "driver", groups: [], stands_for: name, missed: false, ...more };
}

function meeting(here: number): Meeting {
  return { point: 0, program: "p", vertex: "v", here: [], missing: [], here_count: here, count: 3 };
}

const NOTHING = {
  team: { members: [member("a"), member("b"), member("c", { role: "", stands_for: "" })], groups: [], meetings: [] },
  events: [],
};
const GONE = member("a", { role: "", stands_for: "", missed: true });

describe("a run in the words of tutorials", () => {
  it("tells how it ended", () => {
    expect(eventsOf("done", "running")).toEqual(["run-done", "run-ended"]);
    expect(eventsOf("failed", "running")).toEqual(["run-failed", "run-ended"]);
    expect(eventsOf("stopped", "paused")).toEqual(["run-ended"]);
  });

  it("says once that a member waits, and not when all are there", () => {
    const waits = { ...NOTHING, team: { ...NOTHING.team, meetings: [meeting(1)] } };
    expect(eventsOfTeam(waits, NOTHING)).toEqual(["member-waits"]);
    expect(eventsOfTeam({ ...waits, team: { ...waits.team, meetings: [meeting(2)] } }, waits)).toEqual([]);
    expect(eventsOfTeam({ ...NOTHING, team: { ...NOTHING.team, meetings: [meeting(3)] } }, NOTHING)).toEqual([]);
    expect(eventsOfTeam({ ...NOTHING, team: null }, waits)).toEqual([]);
  });

  it("tells one that was replaced from one that was dropped", () => {
    const members = [GONE, member("b")];
    const replaced = {
      ...NOTHING,
      team: { members: [...members, member("c", { stands_for: "a" })], groups: [], meetings: [] },
    };
    expect(eventsOfTeam(replaced, NOTHING)).toEqual(["robot-replaced"]);
    const dropped = { ...NOTHING, team: { members, groups: [], meetings: [] } };
    expect(eventsOfTeam(dropped, NOTHING)).toEqual(["robot-dropped"]);
    expect(eventsOfTeam(dropped, dropped)).toEqual([]);
  });

  it("hears of a failure once", () => {
    const event: RunEvent = { tick: 3, kind: "failure", agent: "a", text: "failed", cause: "person" };
    const failed = { ...NOTHING, events: [event] };
    expect(eventsOfTeam(failed, NOTHING)).toEqual(["robot-failed"]);
    expect(eventsOfTeam({ ...failed, events: [event] }, failed)).toEqual([]);
  });
});
