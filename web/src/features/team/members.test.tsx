/** Who is in which role at the moment of the run, who is missing, and what has changed. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import type { RunEvent, TeamNow } from "../../api/generated";
import { moreWords } from "../../i18n/words";
import { useRun } from "../../session/run";
import { furnish } from "../../testing/graph";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted } from "../../testing/hooks";
import { Members } from "./Members";

const member = (name: string, role: string, stands_for = name, missed = false) => ({
  ...{ name, role, groups: role === "" ? [] : ["convoy"], stands_for, missed, vertices: [] },
});
const TEAM = {
  members: [member("r1", "leader"), member("r2", "", "", true), member("r4", "follower", "r2")],
  groups: [],
  meetings: [{ point: 3, program: "team", vertex: "v1", here_count: 2, count: 3, missing: ["r4"] }],
} as unknown as TeamNow;
const event = (tick: number, agent: string, text: string): RunEvent => ({
  tick,
  kind: "member",
  agent,
  text,
  cause: "program",
});

let page: Mounted;
let hands: Hands;
const seek = vi.fn();
const text = (testId: string) => hands.find(testId).textContent;

beforeEach(async () => {
  furnish();
  await moreWords();
  useRun.setState({
    ...{ status: "paused", tick: 300, latest: 400, tickMs: 20, abilities: ["seek"], seek, team: TEAM, agents: [] },
    events: [
      event(200, "r2", "is missed by its team"),
      event(200, "r4", "takes over for `r2`"),
      event(390, "r1", "goes"),
    ],
  });
  page = mount(<Members />);
  hands = handsOn(page);
});
afterEach(() => {
  page.end();
  useRun.setState(useRun.getInitialState());
});

it("each member has its role, for whom it stands in, and why; who is missed is said", () => {
  expect(text("member-row-r1")).toContain("leader");
  expect(text("member-row-r4")).toContain("follower, for r2");
  expect(text("member-row-r4")).toContain("takes over for r2");
  expect(text("member-row-r2")).toContain("missed");
});

it("a meeting says who is not there yet", () => {
  expect(page.place.querySelector(".members-wait")?.textContent).toContain("2 of 3 are here; r4 is missing");
});

it("changes up to the moment are told, the newest first, and each moment can be gone to", () => {
  const rows = [...hands.find("members-changes").querySelectorAll("li")].map((one) => one.textContent);
  expect(rows).toEqual([expect.stringContaining("takes over for r2"), expect.stringContaining("is missed")]);
  page.act(() => hands.find("members-changes").querySelector("button")?.click());
  expect(seek).toHaveBeenCalledWith(200);
});
