/** What a pupil who left leaves for the next one at the same computer: a place of its own, which that one deletes. */
import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { homeOf } from "../../api/home";
import * as token from "../../api/token";
import { forgetKept, forgetLeft, leaveFiles } from "./left";

beforeEach(() => {
  vi.spyOn(token, "pupilName").mockReturnValue("Ada's key");
});

afterEach(() => {
  localStorage.clear();
  delete document.documentElement.dataset["place"];
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

/** Storage that notes what is deleted, and has deleted it when it is told so. */
function storage() {
  const asked: { onsuccess?: () => void }[] = [];
  const deleteDatabase = vi.fn((name: string) => {
    asked.push({});
    return asked[asked.length - 1] ?? { name };
  });
  vi.stubGlobal("indexedDB", { deleteDatabase });
  return { deleteDatabase, done: () => asked.forEach((one) => one.onsuccess?.()) };
}

test("each site of one address has a place of its own, and in a class each pupil", () => {
  const base = "http://127.0.0.1:8000/school/kit/";
  const places = [homeOf(base, ""), homeOf(`${base}2/`, ""), homeOf(base, "Ada"), homeOf(base, "Ben")];
  expect(new Set(places).size).toBe(places.length);
  // One folder each, whatever the path.
  for (const place of places) expect(place).toMatch(/^\/home\/[^/]+$/u);
});

test("the files of a pupil who left a page with a studio in it are deleted by the next page, until they are gone", () => {
  const { deleteDatabase, done } = storage();
  document.documentElement.dataset["place"] = "page";
  leaveFiles();
  expect(deleteDatabase).not.toHaveBeenCalled();
  forgetLeft();
  forgetLeft();
  expect(deleteDatabase.mock.calls).toEqual(Array(2).fill([homeOf(document.baseURI, "Ada's key")]));
  done();
  forgetLeft();
  expect(deleteDatabase).toHaveBeenCalledTimes(2);
});

test("a pupil whose studio is at the teacher's leaves nothing behind", () => {
  const { deleteDatabase } = storage();
  leaveFiles();
  forgetLeft();
  expect(deleteDatabase).not.toHaveBeenCalled();
});

test("what the page of a pupil who left remembered is forgotten, that of another stays", () => {
  localStorage.setItem("kept.ada", "{}");
  localStorage.setItem("kept.ben", "{}");
  forgetKept("kept.ada");
  expect([localStorage.getItem("kept.ada"), localStorage.getItem("kept.ben")]).toEqual([null, "{}"]);
});
