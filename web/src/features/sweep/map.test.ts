import { expect, test } from "vitest";

import type { SweepMapMessage } from "../../api/generated";
import { countsOf, rowsOf } from "./map";
import { withFailure } from "./sweep-session";

const MAP: SweepMapMessage = {
  type: "map",
  agents: ["a", "b"],
  moments: [0, 1, 2],
  outcome: "done",
  sentence: "",
  total: 6,
  fields: [
    { agent: 1, moment: 2, outcome: "stuck", seconds: 3, sentence: "" },
    { agent: 0, moment: 0, outcome: "done", seconds: 3, sentence: "" },
  ],
};

test("each robot has a row, and what was not run is empty there and counted", () => {
  const rows = rowsOf(MAP);
  expect(rows.map((row) => row.map((field) => field?.outcome ?? ""))).toEqual([
    ["done", "", ""],
    ["", "", "stuck"],
  ]);
  expect(countsOf(MAP)).toEqual({ done: 1, failed: 0, stuck: 1, time: 0, none: 4 });
});

test("a field is played with its failure among those on the schedule, and the mission stays as it is", () => {
  const later = { agent: "b", at_s: 9, kind: "mute" as const };
  const mission = { version: 1 as const, programs: [], agents: [], goals: [], world: "", failures: [later] };
  expect(withFailure(mission, "a", 4.5).failures).toEqual([{ agent: "a", at_s: 4.5, kind: "fail" }, later]);
  expect(mission.failures).toEqual([later]);
});
