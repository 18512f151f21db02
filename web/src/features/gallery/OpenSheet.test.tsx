import { act, createElement } from "react";
import { afterEach, expect, test, vi } from "vitest";

import { journalApi } from "../../api/journal";
import { api } from "../../api/client";
import { traceApi } from "../../api/traces";
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
