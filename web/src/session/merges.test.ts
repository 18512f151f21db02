import { expect, test } from "vitest";

import { useStudio } from "../model/studio";
import type { Mission } from "../model/types";
import { commonBase, keepMerge, revisionMerged } from "./merges";

const mission = (world: string): Mission => ({ version: 1, programs: [], agents: [], goals: [], world });
const [READ, EDITED, THEIRS, MERGED, MORE] = ["read", "edited", "theirs", "merged", "more"].map(mission) as [
  Mission,
  Mission,
  Mission,
  Mission,
  Mission,
];
const NOTHING = { groups: [], robots: [], problems: [] };

function execute(to: Mission): void {
  useStudio.getState().execute({ label: "Edit", execute: () => to });
}

test("what both began with is what was read; a merge takes the file in, and undo gives it back", () => {
  const studio = useStudio.getState();
  studio.openMission({
    path: "a.krt",
    name: "a",
    revision: "1",
    mission: READ,
    catalogue: NOTHING,
    world: null,
    problems: [],
    parts: "",
  });
  expect(commonBase()).toBe(READ);
  execute(EDITED);
  expect([commonBase(), revisionMerged()]).toEqual([READ, "1"]);
  execute(MERGED);
  keepMerge(MERGED, { from: "1", to: "2", theirs: THEIRS });
  expect([commonBase(), revisionMerged()]).toEqual([THEIRS, "2"]);
  execute(MORE);
  expect(revisionMerged()).toBe("2");
  useStudio.getState().undo();
  useStudio.getState().undo();
  expect([commonBase(), revisionMerged()]).toEqual([READ, "1"]);
  useStudio.getState().undo();
  expect(commonBase()).toBe(READ);
  // A state that only redo led to, and that an edit made unreachable.
  useStudio.getState().redo();
  useStudio.getState().markSaved("a.krt", "3");
  expect(commonBase()).toBe(EDITED);
  useStudio.getState().undo();
  expect(commonBase()).toBe(EDITED);
  execute(MORE);
  expect(commonBase()).toBeNull();
});
