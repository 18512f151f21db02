/** What a tutorial says to whom, and that a point opens the panel in which it is. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import type { Point } from "../../api/generated";
import { partsOf } from "../../model/parts";
import { useStudio } from "../../model/studio";
import { useLayout } from "../../session/layout";
import { openRoom, useMobileRoom } from "../../session/narrow";
import { useReveal } from "../../session/reveal";
import { goToPoint, type Page, told } from "./points";

const page: Page = { program: undefined, parts: partsOf(useStudio.getState().catalogue, "") };
const pointer = (coarse: boolean) => vi.stubGlobal("matchMedia", () => ({ matches: coarse }));
const point = (kind: Point["kind"], name: string, inner = ""): Point => ({ kind, name, inner });

beforeEach(() => {
  vi.stubGlobal("requestAnimationFrame", (act: () => void) => {
    act();
    return 0;
  });
  openRoom(null);
});
afterEach(() => vi.unstubAllGlobals());

it.each([
  ["{Click|Tap} it.", "Click it.", "Tap it."],
  ["{Press w.|Choose {Wrap}.} Then Run.", "Press w. Then Run.", "Choose {Wrap}. Then Run."],
  ["No {name} here.", "No {name} here.", "No {name} here."],
  ["{Only a mouse|}", "Only a mouse", ""],
])("%j is %j for a mouse and %j for fingers", (said, mouse, fingers) => {
  pointer(false);
  expect(told({ "": said }, page)).toBe(mouse);
  pointer(true);
  // A name that is not known stays as it is written.
  expect(told({ "": said }, page)).toBe(fingers);
});

it.each([
  [point("part", "Wait"), "palette"],
  [point("panel", "arena"), "arena"],
  [point("panel", "code"), "code"],
  [point("button", "run"), null],
  [point("vertex", "While"), null],
  [point("vertex", "While", "condition"), "inspector"],
  [point("group", "convoy"), "palette"],
])("a point at %j opens the room %j of a phone", (at, room) => {
  openRoom("code");
  goToPoint(at, page);
  expect(useMobileRoom.getState().room).toBe(room);
});

it("a part is shown in the palette, also where that was folded away", () => {
  const { toggle, folded } = useLayout.getState();
  if (!folded.palette) toggle("palette");
  const { times } = useReveal.getState();
  goToPoint(point("part", "Wait"), page);
  expect(useLayout.getState().folded.palette).toBe(false);
  expect(useReveal.getState()).toEqual({ element: "Wait", times: times + 1 });
});
