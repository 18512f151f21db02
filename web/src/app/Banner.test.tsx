/** The message across the page: a question that was asked for has the focus, and Escape is none of its answers. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { dismissBanner, focusQuestion, question } from "../session/document";
import { useLink } from "../session/journal";
import { handsOn } from "../testing/hands";
import { mount, type Mounted } from "../testing/hooks";
import { Banner } from "./Banner";

let page: Mounted;
let before: HTMLButtonElement;
const saved = vi.fn();
const banner = () => page.place.querySelector<HTMLElement>('[data-testid="banner"]');
const buttons = () => [...page.place.querySelectorAll("button")];

beforeEach(() => {
  saved.mockClear();
  before = document.createElement("button");
  document.body.append(before);
  before.focus();
  page = mount(<Banner />);
});
afterEach(() => {
  page.act(dismissBanner);
  page.end();
  before.remove();
  useLink.setState(useLink.getInitialState());
});

it("a question before something goes on has the focus; Escape closes it, and the focus goes back", () => {
  page.act(() => focusQuestion("Unsaved.", [["banner.save", saved]], "Kept."));
  expect(banner()?.textContent).toContain("Unsaved. Kept.");
  expect(document.activeElement).toBe(buttons()[0]);
  page.act(() => buttons()[0]?.dispatchEvent(new KeyboardEvent("keydown", { key: "Escape", bubbles: true })));
  expect([banner(), saved.mock.calls.length, document.activeElement]).toEqual([null, 0, before]);
});

it("another question leaves the focus where it is, and an answer closes it", () => {
  page.act(() => question("Changed.", [["banner.save", saved]]));
  expect([banner()?.getAttribute("role"), document.activeElement]).toEqual(["alert", before]);
  page.act(() => buttons()[0]?.click());
  expect([banner(), saved.mock.calls.length]).toEqual([null, 1]);
});

it("a note is read when there is time for it, and can be closed", () => {
  page.act(() => question("Merged.", [], "note"));
  expect(banner()?.getAttribute("role")).toBe("status");
  page.act(() => buttons()[0]?.click());
  expect(banner()).toBeNull();
});

it("is there as long as nothing reaches the studio", () => {
  page.act(() => useLink.setState({ connected: false }));
  expect(handsOn(page).has("cut-off")).toBe(true);
  page.act(() => useLink.setState({ connected: true }));
  expect(handsOn(page).has("cut-off")).toBe(false);
});
