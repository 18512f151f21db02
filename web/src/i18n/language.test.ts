/** A choice of language, and what else has words of it. */
import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { prepareLanguage, useLanguage } from "./language";
import { speak } from "./words";

beforeEach(() => vi.useFakeTimers());
afterEach(async () => {
  vi.useRealTimers();
  localStorage.clear();
  await speak("en");
  useLanguage.setState({ language: "en" });
});

test("leaves no timer behind", async () => {
  const put = vi.fn();
  prepareLanguage(() => Promise.resolve(put));
  await useLanguage.getState().choose("fr");
  expect(useLanguage.getState().language).toBe("fr");
  expect(put).toHaveBeenCalledOnce();
  expect(vi.getTimerCount()).toBe(0);
});
