/** Saving, and the questions that come up on the way: a name that is taken, a file that somebody else changed. */
import { create } from "zustand";

import { api, ApiError } from "../api/client";
import type { Saved } from "../api/generated";
import { t } from "../i18n/words";
import { useStudio } from "../model/studio";
import type { Mission } from "../model/types";
import { fileName, missionSaved, question, reportError, setSaving, show, whenReady } from "./document";
import { download } from "../ui/download";
import { revisionMerged } from "./merges";
import { loadFromDisk } from "./opening";
import { isFromRecording } from "./recordings";

/** A file of parts, and what is different in it from the one of its name, in words. */
export interface PartDifference {
  file: string;
  changes: readonly string[];
}

interface Saving {
  /** The save that is on its way. */
  pending: Promise<boolean> | null;
  /** Whether it was said already that the folder has no file locks. */
  saidOfLocks: boolean;
  part: PartDifference | null;
}

const useSaving = create<Saving>(() => ({ pending: null, saidOfLocks: false, part: null }));

const set = useSaving.setState;
const pending = () => useSaving.getState().pending;

/** Whether Save has a place to write to: examples and new missions need a name first. */
export function hasPlace(path: string): boolean {
  return path !== "" && !path.startsWith("example:") && !isFromRecording(path);
}

/** Saves where the mission is from, or asks for a name. True when it is on disk. */
export async function save(): Promise<boolean> {
  // One after another: the next needs the revision that this one gives.
  for (let on = pending(); on !== null; on = pending()) await on;
  const { path } = useStudio.getState().file;
  if (!hasPlace(path)) {
    show("save-as");
    return false;
  }
  return write(path, revisionMerged());
}

/** A mission is on disk, as it was when `before` was open and asked to be saved; true when that is what is shown. */
function written({ path, revision, locked }: Saved, mission: Mission, before: unknown): boolean {
  const studio = useStudio.getState();
  // Another one was opened meanwhile: its place is its own.
  if (studio.file !== before) return false;
  studio.markSaved(path, revision, undefined, mission);
  saidOfSave(locked);
  return studio.mission === mission;
}

function saidOfSave(locked: boolean | undefined): void {
  missionSaved();
  if (locked !== false || useSaving.getState().saidOfLocks) return;
  set({ saidOfLocks: true });
  question(t("disk.no-locks"), [], "note", t("disk.no-locks-help"));
}

/** The open mission as a file for the person to keep; false where that failed. */
export async function downloadMission(): Promise<boolean> {
  try {
    const { text } = await api.missionText(useStudio.getState().mission);
    download(fileName(), text, "application/xml");
    return true;
  } catch (cause) {
    reportError(cause);
    return false;
  }
}

export async function write(path: string, revision: string): Promise<boolean> {
  const mine = writeNow(path, revision).finally(() => {
    if (pending() === mine) set({ pending: null });
  });
  set({ pending: mine });
  return mine;
}

async function writeNow(path: string, revision: string): Promise<boolean> {
  setSaving(true);
  await whenReady();
  const { mission, file } = useStudio.getState();
  try {
    return written(await api.saveMission(path, revision, mission), mission, file);
  } catch (cause) {
    if (cause instanceof ApiError && cause.status === 409 && path === useStudio.getState().file.path) {
      conflict(path, cause.revision);
    } else {
      reportError(cause);
    }
    return false;
  } finally {
    setSaving(false);
  }
}

function conflict(path: string, revision: string): void {
  if (revision === "") {
    question(t("disk.removed", { name: fileName() }), [
      ["disk.write", () => void write(path, revision)],
      ["banner.conflict-as", () => show("save-as")],
      ["banner.cancel", () => undefined],
    ]);
    return;
  }
  question(t("banner.conflict", { name: fileName() }), [
    ["banner.conflict-keep", () => void write(path, revision)],
    ["banner.conflict-theirs", loadFromDisk],
    ["disk.difference", () => showDifference(() => conflict(path, revision))],
    ["banner.conflict-as", () => show("save-as")],
  ]);
}

/** What the sheet of differences is about; null: the open mission. */
export const partDifference = () => useSaving.getState().part;

/** Shows what is different between the open mission, or a file of parts, and the file there is; the question stays meanwhile. */
export function showDifference(again: () => void, of: PartDifference | null = null): void {
  set({ part: of });
  show("difference");
  again();
}

/** A new name inside the workspace: null when saved, else the revision of the file that is already there. */
export async function saveAs(path: string, over: string): Promise<{ taken: string } | null> {
  await whenReady();
  const { mission, file } = useStudio.getState();
  try {
    written(await api.saveMission(path, over, mission), mission, file);
    return null;
  } catch (cause) {
    if (cause instanceof ApiError && cause.status === 409) return { taken: cause.revision };
    throw cause;
  }
}
