// @vitest-environment jsdom
import { beforeEach, expect, it } from "vitest";

import type { Robot } from "../model/types";
import { buildWith, type BuiltKit, isAbsent, readKit, suitedRobot, useKit } from "./kit";

const KIT: BuiltKit = {
  name: "tank",
  label: { en: "Tank" },
  absent: { plain: [], rich: [{ category: "actuator", name: "Pen" }], poor: [] },
};
const robot = (name: string, objects: number) =>
  ({ name, objects: Array.from({ length: objects }, () => ({})) }) as unknown as Robot;

beforeEach(() => buildWith(null));

it("a kit is remembered with what it lacks, and forgotten", () => {
  buildWith(KIT);
  expect(readKit(localStorage.getItem("kitrobot.kit"))).toEqual(KIT);
  buildWith(null);
  expect([useKit.getState().kit, localStorage.getItem("kitrobot.kit")]).toEqual([null, null]);
});

it("what somebody else has put there is no kit", () => {
  const odd = [
    "",
    "{",
    "7",
    "[]",
    '{"name":1}',
    '{"name":"a","label":{},"absent":{"r":[1]}}',
    '{"name":"a","label":{"en":1},"absent":{}}',
  ];
  expect(odd.map(readKit)).toEqual(odd.map(() => null));
  expect(readKit(null)).toBeNull();
});

it("a part is absent only of the robot whose part it is, and only of its kind", () => {
  expect(isAbsent(KIT, "rich", { category: "actuator", name: "Pen" })).toBe(true);
  expect(isAbsent(KIT, "plain", { category: "actuator", name: "Pen" })).toBe(false);
  expect(isAbsent(KIT, "rich", { category: "sensor", name: "Pen" })).toBe(false);
  expect(isAbsent(null, "rich", { category: "actuator", name: "Pen" })).toBe(false);
});

it("a kit suits the robot of which it lacks least, the one that is there before a richer one", () => {
  const robots = [robot("rich", 9), robot("plain", 3), robot("poor", 1), robot("unknown", 99)];
  expect(suitedRobot(KIT, robots, "rich")).toBe("plain");
  expect(suitedRobot(KIT, robots, "poor")).toBe("poor");
  expect(suitedRobot(KIT, [], "rich")).toBe("rich");
});
