/**
 * The keys that hold everywhere on the page. A key that an editor, a field or an open menu has used is left alone.
 */
import { useEffect } from "react";

import { runOnRobots, showRobots, stopEverything, useRobotsPanel } from "../boards/state";
import { useStudio } from "../model/studio";
import { printSheet } from "../out/print";
import { fixProblem, walkProblems } from "../problems/walk";
import { newVariable } from "../parts/variables";
import { openTeam } from "../team/view";
import { useRun } from "../run/run";
import { openWorld } from "../world/state";
import { openFind } from "../editor/view";
import { type KeyRow, keyIn, PAGE_KEYS } from "../reach/key-table";
import { closeHelp, explain, toggleOutline, useReach } from "../reach/state";
import { changeSpeed, goToProgram, moveActiveProgram, pause, run, stepVertex } from "./actions";
import { newMission, save, show, useDocument } from "./document";
import { useRenaming } from "./renaming";
import { goToRoom } from "./rooms";

function typing(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLElement &&
    (target.isContentEditable || target.matches("input:not([type=range]), textarea, select"))
  );
}

const ACTIONS: Record<keyof typeof PAGE_KEYS, () => void> = {
  run,
  pause,
  step: () => useRun.getState().step(),
  stepBack: () => useRun.getState().step("tick", true),
  stepVertex: () => stepVertex(false),
  stepVertexBack: () => stepVertex(true),
  stop: stopEverything,
  runOnRobot: runOnRobots,
  slower: () => changeSpeed(-1),
  faster: () => changeSpeed(1),
  create: newMission,
  open: () => show("open"),
  save: () => void save(),
  saveAs: () => show("save-as"),
  print: printSheet,
  undo: () => useStudio.getState().undo(),
  redo: () => useStudio.getState().redo(),
  find: openFind,
  nextProblem: () => walkProblems(1),
  previousProblem: () => walkProblems(-1),
  fix: fixProblem,
  nextRoom: () => goToRoom(1),
  previousRoom: () => goToRoom(-1),
  nextProgram: () => goToProgram(1),
  previousProgram: () => goToProgram(-1),
  programLater: () => moveActiveProgram(1),
  programEarlier: () => moveActiveProgram(-1),
  rename: () => useRenaming.setState({ program: useStudio.getState().activeProgram }),
  addProgram: () => document.querySelector<HTMLElement>(".add-program button")?.click(),
  team: () => openTeam(),
  world: () => openWorld(),
  robots: () => showRobots(!useRobotsPanel.getState().open),
  variable: () => newVariable(),
  outline: toggleOutline,
  part: explain,
  shortcuts: () => show("shortcuts"),
};

/** What a key means here, or null. */
export function keyMeaning(event: KeyboardEvent): (() => void) | null {
  const id = keyIn(PAGE_KEYS, event);
  if (id !== null) {
    const row: KeyRow = PAGE_KEYS[id];
    return row.typing !== true && typing(event.target) ? null : ACTIONS[id];
  }
  if (event.key !== "Escape" || typing(event.target)) return null;
  if (useReach.getState().explained !== null) return closeHelp;
  return useDocument.getState().overlay === null ? null : () => show(null);
}

export function useKeys(): void {
  useEffect(() => {
    const onKeyDown = (event: KeyboardEvent) => {
      if (event.defaultPrevented) return;
      const meaning = keyMeaning(event);
      if (meaning === null) return;
      event.preventDefault();
      meaning();
    };
    window.addEventListener("keydown", onKeyDown);
    return () => window.removeEventListener("keydown", onKeyDown);
  }, []);
}
