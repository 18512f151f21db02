import { expect, test } from "vitest";

import { SeekQueue } from "./seek-queue";

test("one place is asked for at a time, then the newest that waits", () => {
  const sent: number[] = [];
  const queue = new SeekQueue((tick) => sent.push(tick));
  expect(queue.target).toBeNull();
  for (const tick of [50, 100, 150]) queue.ask(tick);
  expect(sent).toEqual([50]);
  expect(queue.target).toBe(150);
  queue.answer();
  expect(sent).toEqual([50, 150]);
  expect(queue.target).toBe(150);
  queue.answer();
  expect(queue.target).toBeNull();
  queue.answer();
  expect(sent).toEqual([50, 150]);
});

test("a queue that is cleared asks anew", () => {
  const sent: number[] = [];
  const queue = new SeekQueue((tick) => sent.push(tick));
  queue.ask(1);
  queue.ask(2);
  queue.clear();
  queue.ask(3);
  expect(sent).toEqual([1, 3]);
});
