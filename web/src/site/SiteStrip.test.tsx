/** What the line about a static site says in each state, and what can be done about it. */
import { act } from "react";
import { createRoot } from "react-dom/client";
import { afterEach, expect, test, vi } from "vitest";

import { moreWords } from "../i18n/words";
import { SiteStrip } from "./SiteStrip";
import { useSite } from "./state";

const first = useSite.getState();
(globalThis as { IS_REACT_ACT_ENVIRONMENT?: boolean }).IS_REACT_ACT_ENVIRONMENT = true;

afterEach(() => {
  useSite.setState(first, true);
  document.body.replaceChildren();
});

async function told(state: Partial<typeof first>): Promise<HTMLElement | null> {
  await moreWords();
  useSite.setState({ ...first, ...state });
  const place = document.createElement("div");
  document.body.replaceChildren(place);
  act(() => createRoot(place).render(<SiteStrip />));
  return place.querySelector("[data-testid=site]");
}

test("a site that is there and keeps the work says nothing", async () => {
  expect(await told({ phase: "ready" })).toBeNull();
});

test("each state that a person should know of is said in a sentence, with a way out where there is one", async () => {
  const states: [Partial<typeof first>, string, string][] = [
    [{ phase: "fetching", fetched: 0.426 }, "KitRobot is coming: 42 %", "status"],
    [{ phase: "starting" }, "KitRobot is starting …", "status"],
    [{ phase: "other-tab" }, "Close that tab", "status"],
    [{ phase: "unfetched", reason: "python.packed" }, "Look whether you are online", "alert"],
    [{ phase: "broken", reason: "no WebAssembly" }, "use a newer version", "alert"],
    [{ phase: "ready", keeping: "full" }, "Nothing is lost while this page stays open", "alert"],
    [{ phase: "ready", keeping: "denied" }, "keeps nothing of this page", "alert"],
    [{ phase: "ready", keeping: "unread" }, "nothing is written over it", "alert"],
  ];
  for (const [state, words, role] of states) {
    const strip = await told(state);
    expect(strip?.textContent).toContain(words);
    expect(strip?.getAttribute("role")).toBe(role);
  }
});

test("a new version is loaded when a person says so", async () => {
  const renew = vi.fn();
  const strip = await told({ phase: "ready", renew });
  expect(strip?.textContent).toContain("There is a new version of KitRobot.");
  strip?.querySelector("button")?.click();
  expect(renew).toHaveBeenCalledOnce();
  const after = await told({ phase: "ready", renew, renewing: true });
  expect(after?.textContent).toContain("loads by itself");
  expect(after?.querySelector("button")).toBeNull();
});
