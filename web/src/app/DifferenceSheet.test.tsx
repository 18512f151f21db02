/** What is different between the mission and its file, and both merged: a choice for what both changed, one step of undo. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import type { Merged } from "../api/generated";
import { journalApi } from "../api/journal";
import { moreWords } from "../i18n/words";
import { useStudio } from "../model/studio";
import { CARRIER, fileOf, missionOf } from "../model/testing/missions";
import { useDocument } from "../session/document";
import { revisionMerged } from "../session/merges";
import { barriersIn } from "../testing/barriers";
import { type Hands, handsOn } from "../testing/hands";
import { mount, type Mounted, settle } from "../testing/hooks";
import { DifferenceSheet } from "./DifferenceSheet";

await moreWords();

const READ = missionOf(CARRIER);
const [MINE, THEIRS, MERGED] = ["mine", "theirs", "merged"].map((world) => ({ ...READ, world }));
let page: Mounted;
let hands: Hands;

beforeEach(async () => {
  useStudio.getState().openMission({ ...fileOf(READ), path: "a.krt", name: "a.krt", revision: "r1" });
  useStudio.getState().execute({ label: "Edit", execute: () => MINE ?? READ });
  vi.spyOn(journalApi, "difference").mockResolvedValue({ changes: ["the duration: 44 → 5"] } as never);
  await settle(() => {
    page = mount(<DifferenceSheet />);
  });
  hands = handsOn(page);
});
afterEach(() => {
  page.end();
  vi.restoreAllMocks();
  useDocument.setState({ banner: null, overlay: null });
});

function answer(taken: boolean): Merged {
  const conflict = { name: "c", what: "the duration", sentence: "", ours: "5", theirs: "44", taken, open: true };
  return { revision: "r2", mission: MERGED, theirs: THEIRS, conflicts: [conflict] } as Merged;
}

it("is told in words; what both changed is chosen, and the merge is one step that undo takes back", async () => {
  expect(hands.find("differences").textContent).toContain("44 → 5");
  expect(await barriersIn(page.place)).toEqual([]);
  const merge = vi.spyOn(journalApi, "merge").mockResolvedValueOnce(answer(false)).mockResolvedValueOnce(answer(true));
  await settle(() => hands.find("merge").click());
  expect(merge.mock.calls[0]).toEqual(["a.krt", READ, MINE, []]);
  expect(hands.find("conflicts").textContent).toContain("the duration");
  await settle(() => hands.find("merge-theirs").click());
  expect(merge.mock.calls[1]?.[3]).toEqual(["c"]);
  await settle(() => hands.find("merge-apply").click());
  expect([useStudio.getState().mission, revisionMerged()]).toEqual([MERGED, "r2"]);
  expect(useDocument.getState().banner?.message).toContain("are merged");
  useStudio.getState().undo();
  expect([useStudio.getState().mission, revisionMerged()]).toEqual([MINE, "r1"]);
});

it("where nothing is in the way it is merged at once; what was edited meanwhile stays", async () => {
  const merge = vi.spyOn(journalApi, "merge").mockImplementation(() => {
    useStudio.getState().execute({ label: "Meanwhile", execute: () => READ });
    return Promise.resolve({ ...answer(false), conflicts: [] });
  });
  await settle(() => hands.find("merge").click());
  expect([useStudio.getState().mission, useDocument.getState().overlay]).toEqual([READ, "difference"]);
  expect(merge).toHaveBeenCalledOnce();
});
