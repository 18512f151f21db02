/** What things of a world are called on the page. */
import { type Key, t } from "../../i18n/words";
import type { OwnWorld } from "../types";
import { type Kind, partOf, type PartReference } from "./part-reference";

export const KIND_ICONS: Record<Kind, string> = {
  wall: "brick-wall",
  floor: "palette",
  line: "pencil",
  road: "signpost",
  storehouse: "warehouse",
  dock: "map-pin",
  start: "bot",
  box: "package",
  ball: "circle",
  zone: "thermometer",
};

export function kindName(kind: Kind): string {
  return t(`world.kind-${kind}` as Key);
}

/** "Road ring", "Wall 2". */
export function nameOf(world: OwnWorld, thing: PartReference): string {
  const part = partOf(world, thing);
  const name = part !== undefined && "name" in part ? part.name : String(thing.at + 1);
  return t("world.thing", { kind: kindName(thing.kind), name });
}
