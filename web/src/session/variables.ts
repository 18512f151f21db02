/**
 * What a person does with the variables of the mission: make, rename, change, remove.
 *
 * The server says whether a variable can be as it is wanted and gives all that the page needs of it; then it is one command.
 * Variables of a robot's own file stay as they are there, and the server says which file that is.
 */
import { create } from "zustand";

import { ApiError } from "../api/client";
import { partsApi, type WantedVariable } from "../api/parts";
import { listed, t } from "../i18n/words";
import { addVariable, changeVariable, removeVariable, renamedIn, usesOfVariable } from "../model/commands/changeOwn";
import { ownVariables } from "../model/own-parts";
import { execute, programInView, useStudio } from "../model/studio";
import type { RobotObject } from "../model/types";
import { reveal as revealVertices } from "./actions";
import { dismissBanner, note, putBanner, reportError } from "./document";
import { useLayout } from "./layout";
import { openRoom } from "./narrow";
import { reveal } from "./reveal";
import { isUnfinished, typeText, useTyping } from "./typing";

export interface Named {
  robot: string;
  name: string;
}

interface Variables {
  /** The form: for a new variable when `was` is "", which may begin with a name. */
  form: { robot: string; was: string; name: string } | null;
  /** The variable whose name is typed over in the palette. */
  renaming: Named | null;
  menu: (Named & { x: number; y: number }) | null;
}

export const useVariables = create<Variables>(() => ({ form: null, renaming: null, menu: null }));

const set = useVariables.setState;

export function closeForm(): void {
  set({ form: null });
}

export function stopRenaming(): void {
  set({ renaming: null });
}

/** Opens the menu of a variable; null closes it. */
export function openVariableMenu(menu: Variables["menu"]): void {
  set({ menu });
}

function robotInView(): string {
  return programInView(useStudio.getState())?.robot ?? "";
}

/** A variable that the mission brings along, or undefined for one of the robot's own file. */
export function ownVariable({ robot, name }: Named): RobotObject | undefined {
  return ownVariables(useStudio.getState().mission).find((one) => one.robot === robot && one.variable.name === name)
    ?.variable;
}

/** Opens the form for a new variable of the robot in view; `name` is what was typed already. */
export function newVariable(name = ""): void {
  const robot = robotInView();
  if (!useStudio.getState().catalogue.robots.some((one) => one.name === robot)) return;
  unfold();
  set({ form: { robot, was: "", name }, menu: null, renaming: null });
}

export function editVariable(of: Named): void {
  if (ownVariable(of) === undefined) return void tellWhere(of);
  unfold();
  set({ form: { robot: of.robot, was: of.name, name: of.name }, menu: null, renaming: null });
}

export function renameVariable(of: Named): void {
  if (ownVariable(of) === undefined) return void tellWhere(of);
  set({ renaming: of, menu: null });
}

function unfold(): void {
  const { folded, toggle } = useLayout.getState();
  if (folded.palette) toggle("palette");
  // On a phone it is a room under the graph.
  openRoom("palette");
}

/** Says in which file a variable is that the mission does not bring along. */
async function tellWhere({ robot, name }: Named): Promise<void> {
  set({ menu: null });
  const { file, mission, catalogue } = useStudio.getState();
  const found = catalogue.robots
    .find((one) => one.name === robot)
    ?.objects.find((one) => one.category === "variable" && one.name === name);
  if (found === undefined) return;
  try {
    await partsApi.variable(file.path, ownVariables(mission), wantedLike(robot, found, name));
  } catch (cause) {
    if (!(cause instanceof ApiError) || cause.status !== 422) return reportError(cause);
    note(cause.message, cause.help);
  }
}

export function wantedLike(robot: string, one: RobotObject, name: string): WantedVariable {
  const { type, min, max, initial, shared } = one;
  return { robot, was: one.name, name, type, min, max, initial, shared };
}

/** Makes or changes a variable. Rejects with an `ApiError` that says why it cannot be. */
export async function keepVariable(wanted: WantedVariable): Promise<void> {
  const { file, mission: asked } = useStudio.getState();
  const made = await partsApi.variable(file.path, ownVariables(asked), wanted);
  const { mission } = useStudio.getState();
  const { robot, was } = wanted;
  const { name } = made.variable;
  const command = was === "" ? addVariable(mission, made) : changeVariable(mission, robot, was, made);
  if (command === null) return;
  const typed = was === "" || was === name ? [] : openTexts(robot);
  execute(command);
  for (const [program, text] of typed) {
    const renamed = renamedIn(text, was, name);
    typeText(program, renamed, { text: renamed, spans: [] });
  }
  if (was === "") reveal(`${name}.${made.variable.methods[0]?.name ?? ""}`);
}

/** Texts with mistakes that people are at: no graph brings them their new names. */
function openTexts(robot: string): [program: string, text: string][] {
  return Object.entries(useTyping.getState().drafts).flatMap(([program, draft]): [string, string][] =>
    draft.program.robot === robot && isUnfinished(program) ? [[program, draft.text]] : [],
  );
}

/** Removes a variable; where it is used that is said first, with a way there. */
export function takeAway(of: Named): void {
  const { robot, name } = of;
  set({ menu: null });
  if (ownVariable(of) === undefined) return void tellWhere(of);
  const remove = () => void execute(removeVariable(useStudio.getState().mission, robot, name));
  const uses = usesOfVariable(useStudio.getState().mission, robot, name);
  if (uses.length === 0) return remove();
  const words = uses.map(({ program, vertices }) => t("variable.used-in", { program, count: vertices.length }));
  const shows = uses.slice(0, 3).map(({ program, vertices }) => ({
    label: t("variable.show-in", { program }),
    run: () => revealVertices(program, vertices),
  }));
  const removes = () => {
    dismissBanner();
    remove();
  };
  putBanner({
    kind: "question",
    message: t("variable.used", { name, places: listed(words) }),
    help: t("variable.used-help"),
    actions: [
      ...shows,
      { label: t("variable.remove-anyway"), run: removes },
      { label: t("variable.keep-it"), run: dismissBanner },
    ],
  });
}
