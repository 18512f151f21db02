/** Moves a program's tab before or behind its neighbour. */
import { t } from "../../i18n/words";
import { becomes, type Command } from "../command";
import type { Mission } from "../types";

/** The command, or null when there is no neighbour on that side. */
export function moveProgram(mission: Mission, name: string, by: 1 | -1): Command | null {
  const from = mission.programs.findIndex((one) => one.name === name);
  const moved = mission.programs[from];
  if (moved === undefined || mission.programs[from + by] === undefined) return null;
  const programs = mission.programs.filter((one) => one !== moved);
  programs.splice(from + by, 0, moved);
  return becomes(t("command.move", { name }), { ...mission, programs });
}
