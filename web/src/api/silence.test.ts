import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { type Silence, watchSilence } from "./silence";

const ask = vi.fn();
const tell = vi.fn<(silent: boolean) => void>();
let silence: Silence;

beforeEach(() => {
  vi.useFakeTimers({ toFake: ["setInterval", "clearInterval"] });
  silence = watchSilence(ask, tell);
});
afterEach(() => {
  silence.end();
  vi.useRealTimers();
  vi.clearAllMocks();
});

it("asks at each beat, and says nothing as long as answers come", () => {
  for (let beat = 0; beat < 10; beat++) {
    vi.advanceTimersByTime(4000);
    silence.heard();
  }
  expect(ask).toHaveBeenCalledTimes(10);
  expect(tell).not.toHaveBeenCalled();
});

it("says once that nothing answers, and once that it does again", () => {
  vi.advanceTimersByTime(8000);
  expect(tell).not.toHaveBeenCalled();
  vi.advanceTimersByTime(40_000);
  expect(tell.mock.calls).toEqual([[true]]);
  silence.heard();
  silence.heard();
  expect(tell.mock.calls).toEqual([[true], [false]]);
});

it("is over with its end", () => {
  silence.end();
  vi.advanceTimersByTime(40_000);
  expect(ask).not.toHaveBeenCalled();
});
