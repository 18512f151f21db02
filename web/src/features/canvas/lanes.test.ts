import { expect, it } from "vitest";

import type { TeamNow } from "../../api/generated";
import { playing } from "./Lanes";

it("a lane says which robots play in it, and for whom one took over", () => {
  const member = (name: string, role: string, groups: string[] = [], stands_for = name) => ({
    name,
    role,
    groups,
    stands_for,
    missed: false,
  });
  const team: TeamNow = {
    members: [
      member("c-1", "carrier", ["movers"]),
      member("c-2", "", []),
      member("c-3", "carrier", ["movers"], "c-2"),
      member("l-1", "loader"),
    ],
    meetings: [],
  };
  expect(playing(["movers"], team)).toBe("c-1, c-3 (c-2)");
  expect(playing(["loader", "c-1"], team)).toBe("c-1, l-1");
  expect(playing(["nobody"], team)).toBe("");
  expect(playing(["movers"], null)).toBe("");
});
