/** Putting robots, roles and groups elsewhere: by dragging, from a menu, and with the same sentences for both. */
import { create } from "zustand";

import { t } from "../../../i18n/words";
import { type Command, commandTo } from "../../../model/command";
import { castAgent, isOfTeam, playing, whyNotCast } from "../../../model/commands/castAgents";
import { groupsOf, joinGroup, leaveGroup, rolesOf } from "../../../model/commands/changeDeclared";
import { execute, useStudio } from "../../../model/studio";
import type { Mission } from "../../../model/types";
import { type MenuEntry, menuItem } from "../../../ui/menu-model";

/** What was done last, or why not, in words. */
export const usePut = create<{ said: string }>(() => ({ said: "" }));

/** What was said of a change holds no more. */
export function forgetSaid(): void {
  usePut.setState({ said: "" });
}

/** What is put elsewhere: an agent, a role or a group by its name, and the group that it is taken from, if any. */
export interface Thing {
  name: string;
  isAgent: boolean;
  from?: string;
}

/** Where to: a role, a group, or out of what it was taken from ("spare"). */
export interface Goal {
  kind: "role" | "group" | "spare";
  name: string;
}

export const goalKey = ({ kind, name }: Goal): string => `${kind} ${name}`;

function agentAt(mission: Mission, name: string): number {
  return mission.agents.findIndex((one) => one.name === name);
}

/** Why a thing cannot go there, or "". */
export function whyNot(mission: Mission, thing: Thing, goal: Goal): string {
  if (goal.kind === "group") return goal.name === thing.name ? t("roster.inside", { name: thing.name }) : "";
  if (thing.from !== undefined && goal.kind === "spare") {
    const group = groupsOf(mission).find((one) => one.name === thing.from);
    return group?.members.length === 1 ? t("roster.last-member", { name: thing.name, group: thing.from }) : "";
  }
  if (!thing.isAgent) return t("roster.gone");
  return whyNotCast(mission, agentAt(mission, thing.name), goal.kind === "role" ? goal.name : "");
}

/** The command that puts a thing there; null where it is there already, or cannot be. */
export function putting(mission: Mission, thing: Thing, goal: Goal): Command | null {
  if (whyNot(mission, thing, goal) !== "") return null;
  const at = (name: string | undefined) => groupsOf(mission).findIndex((one) => one.name === name);
  if (goal.kind === "group") {
    const joined = joinGroup(mission, at(goal.name), thing.name);
    if (joined === null || thing.from === undefined) return joined;
    const after = joined.execute(mission);
    const left = leaveGroup(after, at(thing.from), thing.name);
    return left === null ? joined : commandTo(joined.label, left.execute(after));
  }
  if (thing.from !== undefined && goal.kind === "spare") return leaveGroup(mission, at(thing.from), thing.name);
  return castAgent(mission, agentAt(mission, thing.name), goal.kind === "role" ? goal.name : "");
}

/** Puts a thing there and says so; says why not where it cannot be. */
export function put(thing: Thing, goal: Goal): void {
  const { mission } = useStudio.getState();
  const why = whyNot(mission, thing, goal);
  const isDone = execute(putting(mission, thing, goal));
  const { name } = thing;
  const done = goal.kind === "spare" ? t("roster.free", { name }) : t("roster.moved", { name, place: goal.name });
  usePut.setState({ said: why !== "" ? why : isDone ? done : "" });
}

/** The menu of a thing: every place that it can be in, those where it is marked. */
export function placesOf(thing: Thing): MenuEntry[] {
  const { mission } = useStudio.getState();
  const role = playing(mission).get(thing.name);
  const entry = (
    id: string,
    label: string,
    goal: Goal,
    checked: boolean,
    undone?: Goal & { from: string },
  ): MenuEntry => {
    const why = checked ? "" : whyNot(mission, thing, goal);
    return {
      kind: goal.kind === "group" ? "check" : "radio",
      id,
      label: why === "" ? label : `${label} — ${why}`,
      checked,
      disabled: why !== "",
      run: () => {
        if (!checked) put(thing, goal);
        else if (undone !== undefined) put({ ...thing, from: undone.from }, undone);
      },
    };
  };
  const entries: MenuEntry[] = [];
  if (thing.isAgent) {
    for (const { name } of rolesOf(mission)) {
      entries.push(entry(`put-role-${name}`, t("roster.in-role", { name }), { kind: "role", name }, role === name));
    }
    const agent = mission.agents[agentAt(mission, thing.name)];
    const spare = agent !== undefined && isOfTeam(mission, agent) && role === undefined;
    entries.push(entry("put-spare", t("roster.spare"), { kind: "spare", name: "" }, spare));
    entries.push({ kind: "line", id: "groups" });
  }
  for (const { name, members } of groupsOf(mission)) {
    if (name === thing.name) continue;
    const inside = members.includes(thing.name);
    const out = { kind: "spare", name: "", from: name } as const;
    entries.push(
      entry(
        `put-group-${name}`,
        t("roster.in-group", { name }),
        { kind: "group", name },
        inside,
        inside ? out : undefined,
      ),
    );
  }
  if (thing.from !== undefined) {
    const { from } = thing;
    const why = whyNot(mission, thing, { kind: "spare", name: "" });
    const label = t("roster.take-out", { name: thing.name, group: from });
    entries.push(
      menuItem(
        "put-out",
        why === "" ? label : `${label} — ${why}`,
        "Del",
        () => put(thing, { kind: "spare", name: "" }),
        why !== "",
      ),
    );
  }
  return entries;
}
