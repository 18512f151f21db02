/**
 * Beginning a tutorial, taking it up again, and leaving it with its mission.
 *
 * A tutorial is on as long as its mission is open: opening another mission leaves it. After a reload the tutorial of the
 * mission that comes back is there again.
 */
import { create } from "zustand";

import { api } from "../../api/client";
import type { Tutorial } from "../../api/generated";
import { tutorialApi } from "../../api/tutorials";
import { useStudio } from "../../model/studio";
import { reportError, show, useDocument } from "../../session/document";
import { openMissionOfLesson } from "../../session/open-requests";
import { loadFromDisk } from "../../session/opening";
import { endAll, listen } from "../../ui/effects";
import { begun, openTutorial, type Progress, rememberedProgress } from "./progress";
import { enter, leave, movedTo, setTutorials, useTutorial } from "./state";

/** What is to be entered as soon as its mission is open; `anew`: without the work that was left on it. */
interface Entry {
  tutorial: Tutorial;
  progress: Progress;
  anew: boolean;
}

const useEntry = create<{ waiting: Entry | null }>(() => ({ waiting: null }));

/** Asks which tutorials there are; a folder may have got another one. */
export async function lookForTutorials(): Promise<void> {
  try {
    setTutorials(await tutorialApi.all());
  } catch (cause) {
    // An older list stays; the failure is shown only without one.
    if (useTutorial.getState().all !== null) return;
    setTutorials([]);
    reportError(cause);
  }
}

/** Begins a tutorial, or goes on where it was left. */
export async function begin(tutorial: Tutorial): Promise<void> {
  if (tutorial.steps.length === 0) return;
  const before = rememberedProgress(tutorial);
  if (before === null || before.at >= tutorial.steps.length) {
    beginAnew(tutorial);
    return;
  }
  const path = await stillThere(before.path, tutorial.start);
  wait(tutorial, { ...before, path }, false);
}

/** Begins a tutorial from its first step, with its mission as it was at first. */
export function beginAnew(tutorial: Tutorial): void {
  wait(tutorial, begun(tutorial.start), true);
}

/** The path that the mission was saved to, or `start` when that file is gone. */
async function stillThere(path: string, start: string): Promise<string> {
  if (path === start) return start;
  try {
    await api.mission(path);
    return path;
  } catch {
    return start;
  }
}

function wait(tutorial: Tutorial, progress: Progress, anew: boolean): void {
  show(null);
  useEntry.setState({ waiting: { tutorial, progress, anew } });
  const { file, dirty } = useStudio.getState();
  // The same mission is opened again only to begin anew.
  if (file.path === progress.path && (!anew || !dirty)) arrived();
  else openMissionOfLesson(progress.path);
}

function arrived(): void {
  const { waiting } = useEntry.getState();
  if (waiting === null) return;
  const { tutorial, progress, anew } = waiting;
  useEntry.setState({ waiting: null });
  enter(tutorial, progress);
  // Work that was left on it came back with it.
  if (anew && useStudio.getState().dirty) loadFromDisk();
}

/** Another mission is open now: enters what waits for it, or leaves. */
function opened(path: string): void {
  if (useEntry.getState().waiting?.progress.path === path) {
    arrived();
    return;
  }
  useEntry.setState({ waiting: null });
  const { tutorial, progress } = useTutorial.getState();
  if (tutorial !== null && progress.path !== path) leave();
}

/** After a reload: the tutorial that was open, if its mission is. */
function resume(): void {
  const { all, tutorial } = useTutorial.getState();
  const { path } = useStudio.getState().file;
  if (all === null || tutorial !== null || !useDocument.getState().ready) return;
  const found = all.find((one) => one.name === openTutorial());
  const progress = found === undefined ? null : rememberedProgress(found);
  if (found !== undefined && progress !== null && progress.path === path) enter(found, progress);
}

/** Starts looking after tutorials; the returned function ends it. */
export function keepTutorials(): () => void {
  void lookForTutorials().then(resume);
  const offReady = useDocument.subscribe((state, before) => {
    if (state.ready && !before.ready) resume();
  });
  const offStudio = useStudio.subscribe((state, before) => {
    if (state.change === before.change) return;
    if (state.change.kind === "open") opened(state.file.path);
    else if (state.change.kind === "save") movedTo(state.file.path);
  });
  // Whoever writes one looks at the page after saving its file.
  return endAll(offReady, offStudio, listen(window, { focus: () => void lookForTutorials() }));
}
