/** Runs React hooks and components in tests, without a library for it. */
import { act, createElement, type ReactNode } from "react";
import { createRoot } from "react-dom/client";
import { vi } from "vitest";

(globalThis as { IS_REACT_ACT_ENVIRONMENT?: boolean }).IS_REACT_ACT_ENVIRONMENT = true;

export interface Mounted {
  place: HTMLElement;
  act: (change: () => void) => void;
  end: () => void;
}

/** Puts a tree into the test's document. */
export function mount(tree: ReactNode): Mounted {
  const place = document.createElement("div");
  document.body.append(place);
  const root = createRoot(place);
  act(() => root.render(tree));
  return {
    place,
    act: (change) => act(change),
    end: () => {
      act(() => root.unmount());
      place.remove();
    },
  };
}

/** A hook by itself; `value` is what it gave last. */
export function renderHook<T>(hook: () => T): Mounted & { value: () => T } {
  const seen: T[] = [];
  const Probe = () => {
    seen[0] = hook();
    return null;
  };
  const mounted = mount(createElement(Probe));
  return { ...mounted, value: () => seen[0] as T };
}

/** Does something, and waits until what answers at once has answered, and until parts that come at their first use are there. */
export async function settle(what: () => unknown = () => undefined): Promise<void> {
  await act(async () => {
    what();
    // Answers that wait for answers.
    for (let turn = 0; turn < 30; turn++) await Promise.resolve();
    await vi.dynamicImportSettled();
  });
}
