/** Coming in: what is wrong is said, and a name that is taken asks for the word or the teacher's yes. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { classApi } from "../../api/class";
import { ApiError } from "../../api/client";
import { moreWords } from "../../i18n/words";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted, settle } from "../../testing/hooks";
import { Join } from "./Join";

await moreWords();

let page: Mounted;
let hands: Hands;

beforeEach(async () => {
  vi.spyOn(classApi, "about").mockResolvedValue({ name: "5b", joining: true });
  page = mount(<Join />);
  hands = handsOn(page);
  await settle();
});
afterEach(() => {
  page.end();
  window.history.replaceState(null, "", "#");
  vi.restoreAllMocks();
});

const press = (testId: string) => settle(() => hands.find(testId).click());

it("a code is written in capitals, and one that is wrong is said with what helps", async () => {
  const join = vi.spyOn(classApi, "join").mockRejectedValue(new ApiError("Not the code.", "Ask your teacher.", 403));
  expect(page.place.textContent).toContain("5b");
  hands.fill("join-code", "abc234");
  hands.fill("join-name", "Zoé");
  await press("join-go");
  expect(join).toHaveBeenCalledWith("ABC234", "Zoé", "");
  expect(hands.find("join-failure").textContent).toContain("Not the code. Ask your teacher.");
});

it("a link brings the code along, and the name alone is asked", async () => {
  page.end();
  window.history.replaceState(null, "", "#exercise=x&class=5b&code=ABC234");
  const join = vi.spyOn(classApi, "join").mockReturnValue(new Promise(() => undefined));
  page = mount(<Join />);
  hands = handsOn(page);
  await settle();
  expect(hands.find<HTMLInputElement>("join-code").value).toBe("ABC234");
  expect(document.activeElement).toBe(hands.find("join-name"));
  hands.fill("join-name", "Ada");
  await press("join-go");
  expect(join).toHaveBeenCalledWith("ABC234", "Ada", "");
  // It is followed once the pupil is in.
  expect(window.location.hash).toBe("#exercise=x&class=5b&code=ABC234");
});

it("a link of another class is said, and its code is not typed", async () => {
  page.end();
  window.history.replaceState(null, "", "#exercise=x&class=6a&code=ABC234");
  page = mount(<Join />);
  hands = handsOn(page);
  await settle();
  expect(hands.find("join-other").textContent).toContain("This link is for 6a, and this is 5b.");
  expect(hands.find<HTMLInputElement>("join-code").value).toBe("");
  expect(document.activeElement).toBe(hands.find("join-code"));
});

it("a name that is taken asks for the word, with which the pupil comes back, or for the teacher's yes", async () => {
  const join = vi.spyOn(classApi, "join").mockResolvedValue({ state: "taken", key: null } as never);
  const ask = vi.spyOn(classApi, "ask").mockResolvedValue({ asked: "q" });
  hands.fill("join-code", "abc234");
  hands.fill("join-name", " zoé ");
  expect(hands.has("join-taken")).toBe(false);
  await press("join-go");
  expect(hands.find("join-taken").textContent).toContain("zoé");
  hands.fill("join-word", "def567");
  await press("join-go");
  expect(join).toHaveBeenLastCalledWith("ABC234", " zoé ", "DEF567");
  await press("join-ask");
  expect(ask).toHaveBeenCalledWith("ABC234", " zoé ");
  expect(hands.find<HTMLButtonElement>("join-ask").disabled).toBe(true);
  // Another name is a newcomer.
  hands.fill("join-name", "Ben");
  expect(hands.has("join-taken")).toBe(false);
});
