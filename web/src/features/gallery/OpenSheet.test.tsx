import { act, createElement } from "react";
import { afterEach, expect, test, vi } from "vitest";

import { journalApi } from "../../api/journal";
import { api } from "../../api/client";
import { traceApi } from "../../api/traces";
import { useDocument } from "../../session/document";
import * as opening from "../../session/opening";
import { mount } from "../../testing/hooks";
import { OpenSheet } from "./OpenSheet";

afterEach(() => {
  vi.restoreAllMocks();
});

/** A list that comes when the test says so. */
function awaited<T>() {
  let come: (list: T[]) => void = () => undefined;
  const list = new Promise<T[]>((resolve) => {
    come = resolve;
  });
  return { list, come: () => act(async () => Promise.resolve(come([]))) };
}

test("no list appears above another one that can be pressed already", async () => {
  const [missions, left, recordings] = [awaited<never>(), awaited<never>(), awaited<never>()];
  vi.spyOn(api, "missions").mockReturnValue(missions.list);
  vi.spyOn(journalApi, "left").mockReturnValue(left.list);
  vi.spyOn(traceApi, "all").mockReturnValue(recordings.list);
  const { place, end } = mount(createElement(OpenSheet));
  const lists = () => place.querySelectorAll(".open-lists ul").length;
  for (const { come } of [left, recordings, missions]) {
    expect(lists()).toBe(0);
    await come();
  }
  expect(lists()).toBeGreaterThan(0);
  end();
});

test("work that was left is listed: it is opened with its undo, and what a later KitRobot wrote is told", async () => {
  const one = { path: "blink.krt", name: "blink.krt", modified: "2026-11-30T00:00:00Z", problem: "" };
  const left = [
    { ...one, journal: "j" },
    { ...one, journal: "k", problem: "This journal was written by a later KitRobot" },
  ];
  vi.spyOn(api, "missions").mockResolvedValue([]);
  vi.spyOn(traceApi, "all").mockResolvedValue([]);
  vi.spyOn(journalApi, "left").mockResolvedValue(left);
  const taken = vi.spyOn(opening, "takeLeft").mockResolvedValue(true);
  const { place, end } = await act(async () => {
    const mounted = mount(createElement(OpenSheet));
    for (let turn = 0; turn < 10; turn++) await Promise.resolve();
    return mounted;
  });
  const [mine, later] = place.querySelectorAll<HTMLButtonElement>('[data-testid="open-left"] button');
  expect([mine?.disabled, later?.disabled]).toEqual([false, true]);
  expect(later?.textContent).toContain("a later KitRobot");
  act(() => mine?.click());
  expect(taken).toHaveBeenCalledWith("j");
  expect(useDocument.getState().overlay).toBeNull();
  end();
});
