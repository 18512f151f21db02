/** Links of a static site, and what is handed in there. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { api } from "../api/client";
import { moreWords } from "../i18n/words";
import { useStudio } from "../model/studio";
import { CARRIER, fileOf, missionOf } from "../model/testing/missions";
import { useDocument } from "../session/document";
import { remember, useOpenExercise } from "../session/open-exercise";
import { type Mounted, renderHook, settle } from "../testing/hooks";
import * as files from "../ui/download";
import { isItem, type MenuEntry } from "../ui/menu-model";
import { links } from "./links";

await moreWords();

const NAME = "example:square.exercise.xml";
const START = "example:square.krt";

let menu: Mounted & { value: () => MenuEntry[] };

beforeEach(() => {
  useStudio.getState().openMission({ ...fileOf(missionOf(CARRIER)), path: START, name: "square.krt" });
  useDocument.setState({ ready: true, banner: null });
  vi.spyOn(api, "missionText").mockResolvedValue({ text: "<kitrobot/>" });
  menu = renderHook(() => links.useMenu?.().download ?? []);
});
afterEach(() => {
  menu.end();
  remember(null);
  window.history.replaceState(null, "", "#");
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

const entry = () => menu.value().find(({ id }) => id === "file-copy-exercise-link");
const said = () => useDocument.getState().banner;

it("copies a link to the exercise that is worked on, else shows it in the address bar", async () => {
  const write = vi.fn(() => Promise.resolve());
  vi.stubGlobal("navigator", { ...navigator, clipboard: { writeText: write } });
  expect(entry()).toBeUndefined();
  menu.act(() => remember({ name: NAME, path: START }));
  const copy = entry();
  if (copy === undefined || !isItem(copy)) throw new Error("there is no such entry");
  await settle(copy.run);
  const address = `${window.location.href.split("#")[0] ?? ""}#exercise=${encodeURIComponent(NAME)}`;
  expect(write.mock.calls).toEqual([[address]]);
  expect(said()?.message).toBe("The link is copied: paste it where you want it.");
  write.mockRejectedValueOnce(new Error("no"));
  await settle(copy.run);
  expect(said()?.message).toBe("The link stands in the address bar: copy it from there.");
  expect(window.location.href).toBe(address);
});

it("has no link to an exercise that lies in this browser only", () => {
  menu.act(() => remember({ name: "own.exercise.xml", path: START }));
  expect(entry()).toBeUndefined();
});

it("hands in as a file, and says what to do with it; where that fails it says why", async () => {
  const end = links.start?.();
  const saved = vi.spyOn(files, "download").mockImplementation(() => undefined);
  const handIn = useOpenExercise.getState().handIn;
  await settle(() => handIn?.());
  expect(saved.mock.calls).toEqual([["square.krt", "<kitrobot/>", "application/xml"]]);
  expect(said()?.message).toBe("square.krt is in your downloads: it is what you hand in.");
  vi.mocked(api.missionText).mockRejectedValueOnce(new Error("Python is gone"));
  await settle(() => handIn?.());
  expect([saved.mock.calls.length, said()?.kind]).toEqual([1, "error"]);
  end?.();
  expect(useOpenExercise.getState().handIn).toBeNull();
});
