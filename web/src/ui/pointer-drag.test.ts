import type { PointerEvent as ReactPointerEvent } from "react";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { followPointer } from "./pointer-drag";

/** What happened, in its order. */
let seen: string[];
let part: HTMLElement;

function send(name: string, x: number, y: number): void {
  window.dispatchEvent(new PointerEvent(name, { pointerId: 1, clientX: x, clientY: y, bubbles: true }));
}

function press(pointerType: string): void {
  const down = { button: 0, isPrimary: true, pointerId: 1, pointerType, clientX: 100, clientY: 100 };
  followPointer({ ...down, currentTarget: part } as unknown as ReactPointerEvent, {
    move: ({ x, y }) => seen.push(`at ${String(x)} ${String(y)}`),
    drop: () => seen.push("dropped"),
    end: (moved) => seen.push(moved ? "ended" : "nothing"),
  });
}

beforeEach(() => {
  vi.useFakeTimers();
  seen = [];
  part = document.createElement("div");
  document.body.append(part);
  // A list of parts: what moves along it scrolls.
  vi.spyOn(window, "getComputedStyle").mockImplementation(
    (one) => ({ touchAction: one === part ? "pan-y" : "auto" }) as CSSStyleDeclaration,
  );
});
afterEach(() => {
  vi.restoreAllMocks();
  vi.useRealTimers();
  part.remove();
});

describe("a finger on the list of parts", () => {
  it("scrolls when it swipes along the list, and drags nothing however long it stays then", () => {
    press("touch");
    send("pointermove", 102, 80);
    vi.advanceTimersByTime(1000);
    send("pointermove", 300, 80);
    send("pointerup", 300, 80);
    expect(seen).toEqual(["nothing"]);
  });

  it("drags when it pulls sideways", () => {
    press("touch");
    send("pointermove", 130, 104);
    send("pointermove", 300, 400);
    send("pointerup", 300, 400);
    expect(seen).toEqual(["at 130 104", "at 300 400", "at 300 400", "dropped", "ended"]);
  });

  it("drags after it has rested, then in every direction", () => {
    press("touch");
    vi.advanceTimersByTime(300);
    send("pointermove", 100, 300);
    send("pointerup", 100, 300);
    expect(seen).toEqual(["at 100 100", "at 100 300", "at 100 300", "dropped", "ended"]);
  });

  it("means nothing when it only taps", () => {
    press("touch");
    send("pointermove", 102, 101);
    send("pointerup", 102, 101);
    expect(seen).toEqual(["nothing"]);
  });
});

it("a mouse drags in every direction at once, and Escape gives it up", () => {
  press("mouse");
  send("pointermove", 100, 140);
  window.dispatchEvent(new KeyboardEvent("keydown", { key: "Escape" }));
  send("pointerup", 100, 140);
  expect(seen).toEqual(["at 100 140", "ended"]);
});
