import { act, createElement, useLayoutEffect } from "react";
import { createRoot } from "react-dom/client";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { moreWords } from "../i18n/words";
import { later } from "./later";

let host: HTMLElement;
let root: ReturnType<typeof createRoot>;

const Greeting = ({ name }: { name: string }) => createElement("p", null, `Hello ${name}`);

async function show(element: React.ReactNode): Promise<void> {
  await act(async () => {
    root.render(element);
    // What was fetched has come, and the words with it.
    for (let turn = 0; turn < 5; turn++) await Promise.resolve();
  });
}

// The words that come with every such part are there already.
beforeEach(async () => {
  await moreWords();
  (globalThis as { IS_REACT_ACT_ENVIRONMENT?: boolean }).IS_REACT_ACT_ENVIRONMENT = true;
  host = document.createElement("div");
  root = createRoot(host);
});
afterEach(() => {
  act(() => root.unmount());
});

describe("a part that is fetched later", () => {
  it("is fetched once, when it is first shown, and gets its properties", async () => {
    const load = vi.fn(() => Promise.resolve(Greeting));
    const Later = later(load, vi.fn());
    expect(load).not.toHaveBeenCalled();
    await show(createElement(Later, { name: "Ada" }));
    expect(host.textContent).toBe("Hello Ada");
    await show(null);
    await show(createElement(Later, { name: "Bo" }));
    expect(host.textContent).toBe("Hello Bo");
    expect(load).toHaveBeenCalledTimes(1);
  });

  it("that cannot be fetched is told of, and tried again the next time", async () => {
    const load = vi.fn(() => Promise.resolve(Greeting));
    load.mockRejectedValueOnce(new Error("gone"));
    const fail = vi.fn();
    const Later = later(load, fail);
    await show(createElement(Later, { name: "Ada" }));
    expect(host.textContent).toBe("");
    expect(fail).toHaveBeenCalledTimes(1);
    await show(null);
    await show(createElement(Later, { name: "Ada" }));
    expect(host.textContent).toBe("Hello Ada");
  });

  it("is shown also where it came for another one between drawing and the effects of that", async () => {
    let arrive = (_: typeof Greeting): void => undefined;
    const arriving = {
      then: (there: typeof arrive) => {
        arrive = there;
      },
    };
    const Later = later(() => arriving as unknown as Promise<typeof Greeting>, vi.fn());
    const Between = () => {
      useLayoutEffect(() => arrive(Greeting), []);
      return null;
    };
    const first = createElement(Later, { key: 1, name: "Ada" });
    await show([first]);
    expect(host.textContent).toBe("");
    await show([first, createElement(Later, { key: 2, name: "Bo" }), createElement(Between, { key: 3 })]);
    expect(host.textContent).toBe("Hello AdaHello Bo");
  });
});
