/** What is different from the file is told, and both are merged, with a choice where both changed the same. */
import { act } from "react";
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { moreWords } from "../i18n/words";
import { replaceProgram } from "../model/command";
import { CARRIER, fileOf, missionOf } from "../model/testing/missions";
import { useStudio } from "../model/studio";
import { dismissBanner, show, useDocument } from "../session/document";
import { barriersIn } from "../testing/barriers";
import { furnish } from "../testing/graph";
import { type Hands, handsOn } from "../testing/hands";
import { mount, type Mounted } from "../testing/hooks";
import { testLine, type TestLine } from "../testing/socket";
import { DifferenceSheet } from "./DifferenceSheet";

const THEIRS = missionOf({ ...CARRIER, name: "theirs" });
const conflict = (taken: boolean) => ({
  ...{ name: "c1", what: "The time of `Wait`", sentence: "", ours: "2.0 s", theirs: "4.4 s", taken, open: true },
});

let page: Mounted;
let hands: Hands;
let line: TestLine;
const until = (fact: () => void) =>
  vi.waitFor(async () => {
    await act(() => new Promise<void>((done) => setTimeout(done)));
    fact();
  });

beforeEach(async () => {
  furnish();
  await moreWords();
  line = testLine({
    "api/mission/difference": { changes: ["`Wait` takes 4.4 s instead of 2.0 s."] },
    "api/mission/merge": (sent: unknown) => ({
      ...{ mission: THEIRS, theirs: THEIRS, revision: "2" },
      conflicts: [conflict((sent as { taken: string[] }).taken.length > 0)],
    }),
  });
  useStudio.getState().openMission(fileOf(missionOf(CARRIER)));
  useStudio.getState().execute(replaceProgram("Edit", CARRIER, { ...CARRIER, vertices: CARRIER.vertices.slice(0) }));
  show("difference");
  page = mount(<DifferenceSheet />);
  hands = handsOn(page);
  await until(() => expect(hands.has("differences")).toBe(true));
});
afterEach(() => {
  page.end();
  line.end();
  dismissBanner();
  show(null);
});

it("changes are told in words, without a barrier", async () => {
  expect(hands.find("differences").textContent).toBe("Wait takes 4.4 s instead of 2.0 s.");
  expect(await barriersIn(page.place)).toEqual([]);
});

it("where both changed the same, one is chosen, and the merge is a step that is taken back", async () => {
  hands.click("merge");
  await until(() => expect(hands.has("conflicts")).toBe(true));
  expect(hands.find("conflicts").textContent).toContain("The time of Wait");
  expect(await barriersIn(page.place)).toEqual([]);
  hands.click("merge-theirs");
  await until(() => expect(hands.find<HTMLInputElement>("merge-theirs").checked).toBe(true));
  expect(JSON.parse(String(line.asked.at(-1)?.[1]))).toMatchObject({ taken: ["c1"] });
  await until(() => expect(hands.find<HTMLButtonElement>("merge-apply").disabled).toBe(false));
  hands.click("merge-apply");
  expect([useStudio.getState().mission, useDocument.getState().overlay]).toEqual([THEIRS, null]);
  page.act(() => useStudio.getState().undo());
  expect(useStudio.getState().mission.programs[0]?.name).toBe("carrier");
});
