/** Lets the mission take place in another world. */
import { t } from "../../i18n/words";
import { type Command, commandTo } from "../command";
import type { Mission } from "../types";

/** What a mission calls the empty world when it says it. */
const EMPTY = "empty.world.xml";

/** In the place of a file's name where a world is the mission's own; no file has that name. */
export const OWN_WORLD = "/own";

/** Whether two missions' words for a world mean the same one. */
export function sameWorld(one: string, other: string): boolean {
  return (one || EMPTY) === (other || EMPTY);
}

/** `world` is the name of its file, "" for the empty one; null when the mission is there already. */
export function changeWorld(mission: Mission, world: string): Command | null {
  const own = mission.own_world != null;
  if (!own && sameWorld(mission.world, world)) return null;
  const after = { ...mission, world, ...(own ? { own_world: null } : {}) };
  return commandTo(t("command.world"), after);
}
