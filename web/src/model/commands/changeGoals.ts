/** Adds, changes and removes goals: what a storehouse holds in the end, as a number of boxes or all of them. */
import { t } from "../../i18n/words";
import { type Command, commandTo } from "../command";
import type { Goal, Mission } from "../types";

export const ALL = "all";

function withGoals(label: string, before: Mission, goals: Goal[]): Command {
  return commandTo(label, { ...before, goals });
}

/** A new goal at the end: everything in that storehouse. */
export function addGoal(mission: Mission, storehouse: string): Command | null {
  if (storehouse === "") return null;
  const goals = [...mission.goals, { storehouse, stock: ALL }];
  return withGoals(t("command.add", { name: t("team.goal") }), mission, goals);
}

/** Another goal in the place of one; null when it is the same. Numbers that are typed one after another are one step. */
export function changeGoal(mission: Mission, at: number, goal: Goal): Command | null {
  const before = mission.goals[at];
  if (before === undefined || (before.storehouse === goal.storehouse && before.stock === goal.stock)) return null;
  const command = withGoals(t("command.edit", { name: t("team.goal") }), mission, mission.goals.with(at, goal));
  return { ...command, joins: `goal ${String(at)} ${goal.storehouse}` };
}

export function removeGoal(mission: Mission, at: number): Command | null {
  if (mission.goals[at] === undefined) return null;
  return withGoals(t("command.delete", { name: t("team.goal") }), mission, mission.goals.toSpliced(at, 1));
}
