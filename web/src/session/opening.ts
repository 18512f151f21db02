/** How a mission becomes the open one: from a file, a recording, or the work that was left on it. */
import { create } from "zustand";

import { api } from "../api/client";
import type { ClaimedJournal, Recording } from "../api/generated";
import { t } from "../i18n/words";
import { type History, isUnsaved } from "../model/history";
import { useStudio } from "../model/studio";
import type { MissionFile } from "../model/types";
import {
  drawnAhead,
  drawnMissionOpened,
  fileName,
  missionOpened,
  question,
  reportError,
  setOpening,
  useDocument,
} from "./document";
import { earlyWorkOn } from "./early-work";
import { claim, keepOpen, openWith } from "./journal";
import { recover, type Recovered } from "./journal-records";
import { begin as play } from "./recordings";
import { useRun } from "./run";
import { holdParts } from "./world-files";

/** Opens a mission with its unsaved work; `journal` names the journal, "" for any. */
export async function take(file: MissionFile, journal = ""): Promise<void> {
  resume(file, await claim(file.path, journal));
}

/**
 * Draws the mission that will be open, with what was done to it earlier, where there is none yet: what follows from opening it
 * comes with `take`.
 */
export function drawAhead(file: MissionFile, history?: History): void {
  if (useDocument.getState().ready) return;
  useStudio.getState().openMission(file, history);
  holdParts(file.parts ?? "");
  drawnAhead();
}

/** Whether a mission is the one that was drawn ahead, and stays as it is now: nothing newer was kept of it. */
function staysDrawn({ path, revision }: MissionFile, kept: Recovered | null): boolean {
  const { file, canUndo, canRedo } = useStudio.getState();
  const same = useDocument.getState().ahead && file.path === path && file.revision === revision;
  return same && (canUndo || canRedo || kept === null);
}

/** The mission that was drawn ahead becomes the open one: what is selected, dragged or typed there goes on. */
function openDrawn(file: MissionFile): void {
  keepOpen();
  useStudio.getState().loadParts(file.catalogue);
  holdParts(file.parts ?? "");
  drawnMissionOpened(file.problems);
}

/** Opens a mission with what its journal holds, as far as that is still of use. */
function resume(file: MissionFile, claimed: ClaimedJournal | null): void {
  const kept = recover(claimed?.records ?? []);
  if (staysDrawn(file, kept)) {
    openDrawn(file);
    return;
  }
  const found = kept ?? earlyWorkOn(file);
  const unsaved = found !== null && isUnsaved(found.history);
  const back = found !== null && (unsaved || found.revision === file.revision) ? found : null;
  openWith(back?.history ?? null);
  useRun.getState().reset();
  useStudio.getState().openMission(back === null ? file : { ...file, revision: back.revision }, back?.history);
  holdParts(file.parts ?? "");
  missionOpened(file.problems);
  if (!unsaved) return;
  const help = t(
    found.lost === "steps"
      ? "journal.back-steps"
      : claimed?.damaged === true
        ? "journal.back-damaged"
        : "journal.back-help",
  );
  question(t("journal.back", { name: fileName() }), [["journal.discard", discard]], "note", help);
}

/** Away with what is not saved: the file as it is on disk, or a new one. */
function discard(): void {
  const { path } = useStudio.getState().file;
  void bringMission(() => (path === "" ? api.newMission() : api.mission(path)));
}

/** Opens work that was left behind; false when it is gone. */
export async function takeLeft(journal: string): Promise<boolean> {
  const claimed = await claim("", journal);
  if (claimed === null || claimed.records.length === 0) return false;
  resume({ ...(await under(claimed.path)), path: claimed.path, name: claimed.name }, claimed);
  return true;
}

/** What lies under unsaved work: its file, or nothing when that is gone. */
async function under(path: string): Promise<MissionFile> {
  if (path === "") return api.newMission();
  try {
    return await api.mission(path);
  } catch {
    return api.newMission();
  }
}

/** Opens the file on disk in place of what is open. */
export function loadFromDisk(): void {
  const { path } = useStudio.getState().file;
  void bringMission(() => api.mission(path));
}

const useUnderWay = create(() => ({ count: 0 }));

function countOpening(by: 1 | -1): void {
  useUnderWay.setState(({ count }) => ({ count: count + by }));
  setOpening(useUnderWay.getState().count > 0);
}

export async function whileOpening<T>(work: Promise<T>): Promise<T> {
  countOpening(1);
  try {
    return await work;
  } finally {
    countOpening(-1);
  }
}

/** True when what `get` gives is open; a failure is reported, and the open mission stays. */
function bring<T>(get: () => Promise<T>, open: (found: T) => Promise<void>): Promise<boolean> {
  return whileOpening(
    get()
      .then(open)
      .then(
        () => true,
        (cause: unknown) => {
          reportError(cause);
          return false;
        },
      ),
  );
}

export const bringMission = (get: () => Promise<MissionFile>) => bring(get, take);

/** Opens the mission of a recording, and plays it. */
export const bringRecording = (get: () => Promise<Recording>) =>
  bring(get, async (found) => {
    await take(found.file);
    play(found);
  });
