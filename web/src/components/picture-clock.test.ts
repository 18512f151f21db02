import { afterEach, expect, test, vi } from "vitest";

import { keepDrawing, movingPictures } from "./picture-clock";
import { momentAfter } from "./RunPicture";

afterEach(() => {
  vi.restoreAllMocks();
});

test("the clock runs while a picture moves, and ends with the last one", () => {
  const asked = new Map<number, FrameRequestCallback>();
  let number = 0;
  vi.spyOn(window, "requestAnimationFrame").mockImplementation((callback) => {
    asked.set(++number, callback);
    return number;
  });
  vi.spyOn(window, "cancelAnimationFrame").mockImplementation((which) => {
    asked.delete(which);
  });
  const frame = (now: number) => {
    const callbacks = [...asked.values()];
    asked.clear();
    for (const callback of callbacks) callback(now);
  };
  const [first, second] = [vi.fn(), vi.fn()];
  const endFirst = keepDrawing(first);
  const endSecond = keepDrawing(second);
  expect([movingPictures(), asked.size]).toEqual([2, 1]);
  frame(1000);
  // Not more often than a small picture needs.
  frame(1010);
  frame(1050);
  expect(first.mock.calls).toEqual([[1000], [1050]]);
  endFirst();
  frame(1100);
  expect([first.mock.calls.length, second.mock.calls.length]).toEqual([2, 3]);
  endSecond();
  expect([movingPictures(), asked.size]).toEqual([0, 0]);
});

test("a preview is played at its pace, its end is shown for a while, and it begins anew", () => {
  expect(momentAfter(0, 41)).toBe(0);
  expect(momentAfter(2050, 41)).toBeCloseTo(20.5);
  expect(momentAfter(4500, 41)).toBe(40);
  expect(momentAfter(5300, 41)).toBeCloseTo(1);
  expect(momentAfter(5300, 1)).toBe(0);
});
