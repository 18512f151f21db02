/** The groups of the XML with the parts that stand in each: the order of the palette, and of what is offered first. */
import type { Parts, Shape } from "./parts";
import type { Group } from "./types";

const HELD = { actuator: "actuators", sensor: "sensors", variable: "values", system: "values" } as const;

/** The place of a part that names none: behind those that do. */
export const LAST_PLACE = 1000;

export const placeInGroup = ({ constructor_, method }: Shape): number =>
  constructor_?.order ?? method?.order ?? LAST_PLACE;

/** The group of a part: the one it names, the one of its object, or the one for parts of its kind. */
export function groupOf({ groups }: Parts, { constructor_, method, object }: Shape): Group | undefined {
  const named = [constructor_?.group, method?.group, object?.group];
  const held = object === null ? "" : HELD[object.category];
  return (
    named.flatMap((name) => groups.find((group) => group.name === name) ?? [])[0] ??
    groups.find((group) => held !== "" && group.holds === held)
  );
}

const OWN_GROUPS = 2;
const LOOPS = 2;

/** What an empty program is offered: the first action of the robot's first groups, then the first loops. */
export function firstParts(parts: Parts): Shape[] {
  const inOrder = parts.all.toSorted((a, b) => placeInGroup(a) - placeInGroup(b));
  const actions = inOrder.filter((shape) => shape.object?.category === "actuator" && shape.role === "instruction");
  const byGroup = parts.groups.flatMap(
    (group) => actions.find((shape) => groupOf(parts, shape)?.name === group.name) ?? [],
  );
  const loops = inOrder.filter(
    (shape) => shape.kind === "constructor" && shape.colour === "loop" && hasOnlyABody(shape),
  );
  return [...byGroup.slice(0, OWN_GROUPS), ...loops.slice(0, LOOPS)];
}

/** Whether it asks for nothing but what it holds. */
function hasOnlyABody({ flows, plugs }: Shape): boolean {
  return flows.length === 1 && plugs.length === 0;
}
