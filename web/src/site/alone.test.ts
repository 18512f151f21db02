/** One tab at a time has the studio: the second waits until the first is gone, with the browser's locks and without. */
import { afterEach, expect, test, vi } from "vitest";

import { alone } from "./alone";

afterEach(() => {
  vi.unstubAllGlobals();
  Reflect.deleteProperty(navigator, "locks");
});

/** A tab that asks for the studio. */
function tab(name = "kitrobot /kit/") {
  const turn = { begin: vi.fn(), wait: vi.fn() };
  alone(name, turn);
  return turn;
}

interface Held {
  close: () => void;
  version: number;
}

/** The browser's databases as far as versions go: a new one waits until nobody has the old one open. */
function databases() {
  const open = new Map<string, Set<Held>>();
  const versions = new Map<string, number>();
  const waiting: (() => void)[] = [];
  const opened: Held[] = [];
  const request = (name: string, version?: number) => {
    const asked: Record<string, unknown> &
      Record<"onsuccess" | "onupgradeneeded" | "onblocked", (() => void) | undefined> = {
      onsuccess: undefined,
      onupgradeneeded: undefined,
      onblocked: undefined,
    };
    const there = open.get(name) ?? new Set<Held>();
    open.set(name, there);
    const go = () => {
      const now = versions.get(name) ?? 0;
      const wanted = version ?? Math.max(now, 1);
      const close = () => {
        there.delete(held);
        waiting.splice(0).forEach((one) => one());
      };
      const held: Held = { version: wanted, close };
      if (wanted > now && there.size > 0) {
        asked.onblocked?.();
        waiting.push(go);
        return;
      }
      there.add(held);
      opened.push(held);
      asked["result"] = held;
      if (wanted > now) {
        versions.set(name, wanted);
        asked.onupgradeneeded?.();
      }
      asked.onsuccess?.();
    };
    queueMicrotask(go);
    return asked;
  };
  vi.stubGlobal("indexedDB", { open: request });
  /** Closes what a tab has that is closed. */
  return { leave: () => opened.forEach((one) => one.close()) };
}

test("without locks the second tab waits until the first is closed", async () => {
  const { leave } = databases();
  const first = tab();
  await vi.waitFor(() => expect(first.begin).toHaveBeenCalledOnce());
  const second = tab();
  await vi.waitFor(() => expect(second.wait).toHaveBeenCalled());
  expect(second.begin).not.toHaveBeenCalled();
  expect(first.wait).not.toHaveBeenCalled();
  leave();
  await vi.waitFor(() => expect(second.begin).toHaveBeenCalledOnce());
});

test("without locks the tab of another site waits for nobody", async () => {
  databases();
  const first = tab();
  const other = tab("kitrobot /other/");
  await vi.waitFor(() => expect([first.begin, other.begin].map((one) => one.mock.calls.length)).toEqual([1, 1]));
});

test("a browser that gives neither locks nor databases begins", async () => {
  vi.stubGlobal("indexedDB", undefined);
  const only = tab();
  await vi.waitFor(() => expect(only.begin).toHaveBeenCalledOnce());
  expect(only.wait).not.toHaveBeenCalled();
});
