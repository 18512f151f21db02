/**
 * Brings a world into the mission and changes it there; each change is one step of undo.
 *
 * Who renames a road, a dock, a storehouse or a start takes along everything that calls it by name: other things of the
 * world, the team's starts and goals.
 */
import { t } from "../../i18n/words";
import { type Command, commandTo } from "../command";
import { startOf } from "../starts";
import type { Mission, OwnWorld } from "../types";
import { type Kind, partsOfKind, type PartReference } from "../world/part-reference";
import { removed, withDependents, withPart } from "../world/part-edits";

/** The mission takes place in this world, which it brings along from now on. */
export function bringWorld(mission: Mission, world: OwnWorld): Command {
  return commandTo(t("world.bring"), { ...mission, world: "", own_world: world });
}

/** Another world in the place of the mission's own; null when it is the same or there is none. */
export function changeOwnWorld(mission: Mission, label: string, world: OwnWorld, joins?: string): Command | null {
  const before = mission.own_world ?? null;
  if (before === null || JSON.stringify(before) === JSON.stringify(world)) return null;
  return commandTo(label, { ...mission, own_world: world }, joins === undefined ? {} : { joins });
}

/** Things out of the world, with what cannot be without them. */
export function removeThings(mission: Mission, label: string, things: readonly PartReference[]): Command | null {
  const world = mission.own_world ?? null;
  if (world === null || things.length === 0) return null;
  return changeOwnWorld(mission, label, removed(world, withDependents(world, things)));
}

export type NamedKind = "road" | "storehouse" | "dock" | "start";

/** Whether a thing of that kind may have the name. */
export function isFreeName(world: OwnWorld, kind: NamedKind, name: string): boolean {
  return name !== "" && !partsOfKind(world, kind).some((part) => part.name === name);
}

export function isNamed(kind: Kind): kind is NamedKind {
  return kind === "road" || kind === "storehouse" || kind === "dock" || kind === "start";
}

/** Another name for a thing, everywhere; null when it cannot be. */
export function renameThing(mission: Mission, { kind, at }: PartReference, name: string): Command | null {
  const world = mission.own_world ?? null;
  if (world === null || !isNamed(kind) || !isFreeName(world, kind, name)) return null;
  const part = partsOfKind(world, kind)[at];
  if (part === undefined) return null;
  const was = part.name;
  let after = withPart(world, { kind, at }, { ...part, name });
  let team: Partial<Mission> = {};
  if (kind === "start") {
    team = {
      agents: mission.agents.map((agent) =>
        startOf(agent) === was ? { ...agent, start: name === agent.name ? "" : name } : agent,
      ),
    };
  } else {
    const named = <P extends object>(list: P[]): P[] =>
      list.map((one) => ((one as Record<string, unknown>)[kind] === was ? { ...one, [kind]: name } : one));
    after = { ...after, starts: named(after.starts), docks: kind === "dock" ? after.docks : named(after.docks) };
    if (kind === "storehouse") {
      team = {
        goals: mission.goals.map((goal) => (goal.storehouse === was ? { ...goal, storehouse: name } : goal)),
      };
    }
  }
  return commandTo(t("command.rename", { name }), { ...mission, ...team, own_world: after });
}
