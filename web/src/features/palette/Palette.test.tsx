/** The parts of the palette: of the robot that is chosen above them, and of the kit that somebody builds with. */
import { afterEach, beforeEach, expect, it } from "vitest";

import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { PARTS } from "../../model/testing/parts";
import { buildWith } from "../../session/kit";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted, settle } from "../../testing/hooks";
import { Palette } from "./Palette";

await moreWords();

const [carrier] = PARTS.robots;
/** The carrier without its motor. */
const plain = { ...carrier, name: "plain", objects: carrier?.objects.filter(({ name }) => name !== "Motor") ?? [] };
let page: Mounted;
let hands: Hands;

beforeEach(() => {
  localStorage.clear();
  buildWith(null);
  const catalogue = { ...PARTS, robots: [...PARTS.robots, plain as (typeof PARTS.robots)[number]] };
  useStudio.getState().openMission({ ...fileOf(missionOf(CARRIER)), catalogue });
  page = mount(<Palette />);
  hands = handsOn(page);
});
afterEach(() => {
  page.end();
  buildWith(null);
});

const entry = (name: string) => document.querySelector<HTMLElement>(`[data-testid="menu-robot-${name}"]`);

it("the robot is changed above its parts, and undo gives back the one before", async () => {
  expect([hands.find("palette-robot").textContent, hands.has("object-Motor")]).toEqual(["carrier", true]);
  await settle(() => hands.find("palette-robot").click());
  expect(entry("carrier")?.getAttribute("aria-checked")).toBe("true");
  await settle(() => entry("plain")?.click());
  expect(hands.find("palette-robot").textContent).toBe("plain");
  expect(hands.has("object-Motor")).toBe(false);
  page.act(() => useStudio.getState().undo());
  expect([hands.find("palette-robot").textContent, hands.has("object-Motor")]).toEqual(["carrier", true]);
});

it("parts that a kit has nothing for are left out, with a word, until all are wanted again", async () => {
  await settle(() =>
    buildWith({ name: "k", label: { "": "Tank" }, absent: { carrier: [{ category: "actuator", name: "Motor" }] } }),
  );
  expect(hands.find("palette-kit").textContent).toContain("Tank");
  expect([hands.has("object-Motor"), hands.has("object-Wheel")]).toEqual([false, true]);
  hands.click("palette-all-parts");
  expect([hands.has("object-Motor"), hands.has("palette-kit")]).toEqual([true, false]);
});
