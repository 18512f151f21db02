import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { useStudio } from "../model/studio";
import { CARRIER, fileOf, missionOf } from "../model/testing/missions";
import { hearOfDisk, useDisk, watchDisk } from "./disk";
import { useDocument } from "./document";

const PATH = "blink.krt";
let stop = () => {};

const hear = (revision: string) => hearOfDisk({ ...useDisk.getState(), path: PATH, revision });
const saved = (revision: string) =>
  useStudio.getState().markSaved(PATH, revision, undefined, useStudio.getState().mission);
const isAsked = () => useDocument.getState().banner !== null;

beforeEach(() => {
  const mission = missionOf(CARRIER);
  useStudio.setState({ mission, dirty: false, file: { ...useStudio.getState().file, path: PATH, revision: "opened" } });
  useDocument.setState({ ready: true, saving: false, banner: null });
  stop = watchDisk();
  hear("opened");
});

afterEach(() => {
  stop();
  useDocument.setState({ ready: false, banner: null });
});

it("does not ask about our own saves, also where news of the first come after the second", () => {
  saved("first");
  saved("second");
  for (const revision of ["opened", "first", "second"]) {
    hear(revision);
    expect(isAsked(), revision).toBe(false);
  }
});

it("asks when somebody brings back what was there before our own save", () => {
  saved("first");
  hear("first");
  hear("opened");
  expect(isAsked()).toBe(true);
});

it("asks about what somebody else has written", () => {
  saved("first");
  hear("theirs");
  expect(isAsked()).toBe(true);
});

it("loads what somebody else has written when it is wanted", async () => {
  const choose = (label: string) =>
    useDocument
      .getState()
      .banner?.actions.find((one) => one.label === label)
      ?.run();
  hear("later");
  expect(isAsked()).toBe(true);
  const found = { ...fileOf(missionOf({ ...CARRIER, name: "loaded" })), path: PATH, revision: "later" };
  const asked = vi.fn(() => Promise.resolve(Response.json(found)));
  vi.stubGlobal("fetch", asked);
  choose("Load it");
  await vi.waitFor(() => expect(useStudio.getState().mission.programs[0]?.name).toBe("loaded"));
  expect(asked).toHaveBeenCalledOnce();
  expect(isAsked()).toBe(false);
  vi.unstubAllGlobals();
});
