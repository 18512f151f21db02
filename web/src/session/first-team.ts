/** Starts programs of a team: the first one of the whole team, which the server makes of what the robots do now. */
import { ask } from "../api/client";
import { moreWords, t } from "../i18n/words";
import { commandTo } from "../model/command";
import { addProgram, emptyProgram } from "../model/commands/changePrograms";
import { freeStem } from "../model/free-name";
import { execute, useStudio } from "../model/studio";
import { TEAM_ROBOT } from "../model/team-robot";
import type { Mission } from "../model/types";
import { reportError } from "./document";
import { closeTeam, showSide } from "./team-view";

/** Makes the program of the whole team and opens it; the robots run it from now on. */
export async function startTeam(): Promise<void> {
  await moreWords();
  const { mission, file } = useStudio.getState();
  try {
    const json = { mission, path: file.path, name: t("first-team.name") };
    const after = await ask<Mission>("mission/team", { method: "POST", json });
    const { mission: now, setActiveProgram } = useStudio.getState();
    // What was edited meanwhile is worth more than an answer about what was there before.
    if (now !== mission) return;
    execute(commandTo(t("command.first-team"), { ...mission, ...after }));
    const made = after.programs.find((one) => mission.programs.every(({ name }) => name !== one.name));
    if (made !== undefined) setActiveProgram(made.name);
    closeTeam();
    showSide("team");
  } catch (cause) {
    reportError(cause, () => void startTeam());
  }
}

/** An empty program of a group, which the program of the whole team can name. */
export async function addGroupProgram(): Promise<void> {
  await moreWords();
  const { mission, setActiveProgram } = useStudio.getState();
  const stem = t("first-team.group-name");
  const isTaken = (name: string) => mission.programs.some((one) => one.name === name);
  const name = freeStem(stem, isTaken);
  if (execute(addProgram(mission, emptyProgram(name, TEAM_ROBOT, "group")))) setActiveProgram(name);
}
