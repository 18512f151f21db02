import { expect, it } from "vitest";

import { firstParts } from "./part-groups";
import { partsOf } from "./parts";
import { CARRIER_PARTS } from "./testing/missions";
import { PARTS } from "./testing/parts";

it("an empty program is offered the first action of the robot's first groups, and what repeats", () => {
  expect(firstParts(CARRIER_PARTS).map(({ element }) => element)).toEqual(["Wheel.Advance", "Repetition"]);
});

it("a robot that only senses, and one that nobody knows, are offered what repeats", () => {
  const still = PARTS.robots.map((robot) => ({
    ...robot,
    objects: robot.objects.filter(({ category }) => category !== "actuator"),
  }));
  for (const parts of [partsOf({ ...PARTS, robots: still }, "carrier"), partsOf(PARTS, "nobody")])
    expect(firstParts(parts).map(({ element }) => element)).toEqual(["Repetition"]);
  expect(firstParts(partsOf({ ...PARTS, groups: [] }, "carrier"))).toEqual([]);
});
