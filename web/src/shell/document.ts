/**
 * The open mission and its file: opening, saving, downloading, and the questions that come up on the way.
 *
 * The mission itself is in `useStudio`; here is what surrounds it: the session, one banner (a failure or a question, never a
 * blocking dialog) and which panel lies over the page. Whatever would throw unsaved changes away asks first.
 */
import { create } from "zustand";

import { api, ApiError, type Session } from "../api/client";
import type { MissionFile, Problem } from "../api/types";
import { useStudio } from "../model/studio";
import { useRun } from "../run/run";
import { type Key, sentence, t } from "../words/words";
import { download } from "./download";

export interface BannerAction {
  label: string;
  run: () => void;
}

export interface Banner {
  kind: "error" | "question";
  message: string;
  help: string;
  actions: BannerAction[];
}

export type Overlay = "open" | "save-as" | "shortcuts" | "about" | null;

interface DocumentState {
  session: Session | null;
  /** False until the first mission is there. */
  ready: boolean;
  saving: boolean;
  banner: Banner | null;
  overlay: Overlay;
  /** What was wrong with the file itself when it was read; it goes away with the next save. */
  fileProblems: Problem[];
}

export const useDocument = create<DocumentState>(() => ({
  session: null,
  ready: false,
  saving: false,
  banner: null,
  overlay: null,
  fileProblems: [],
}));

const set = useDocument.setState;

export function show(overlay: Overlay): void {
  set({ overlay });
}

export function dismissBanner(): void {
  set({ banner: null });
}

function placed({ line, message }: Problem): string {
  return line > 0 ? t("banner.line", { line, message }) : sentence(message);
}

/** Says that something failed, with a way to try again where there is one. */
export function complain(cause: unknown, again?: () => void): void {
  const message = cause instanceof Error ? cause.message : String(cause);
  const help =
    cause instanceof ApiError ? [...cause.problems.slice(0, 1).map(placed), cause.help].join(" ").trim() : "";
  const actions = again === undefined ? [] : [{ label: t("banner.retry"), run: again }];
  set({ banner: { kind: "error", message, help, actions } });
}

function question(message: string, choices: [Key, () => void][]): void {
  const actions = choices.map(([key, run]) => ({
    label: t(key),
    run: () => {
      dismissBanner();
      run();
    },
  }));
  set({ banner: { kind: "question", message, help: "", actions } });
}

/** A file's name without its folders. */
export function shownName(name: string): string {
  return name.split("/").at(-1) || t("file.untitled");
}

/** The open file's name as the page shows it. */
export function fileName(): string {
  return shownName(useStudio.getState().file.name);
}

/** Whether Save has a place to write to: examples and new missions need a name first. */
export function hasPlace(path: string): boolean {
  return path !== "" && !path.startsWith("example:");
}

function unlessUnsaved(go: () => void): void {
  if (!useStudio.getState().dirty) {
    go();
    return;
  }
  question(t("banner.unsaved", { name: fileName() }), [
    ["banner.save", () => void save().then((saved) => saved && go())],
    ["banner.discard", go],
    ["banner.cancel", () => undefined],
  ]);
}

function take(file: MissionFile): void {
  useRun.getState().reset();
  useStudio.getState().openMission(file);
  set({ ready: true, banner: null, overlay: null, fileProblems: file.problems });
}

async function bring(get: () => Promise<MissionFile>): Promise<void> {
  try {
    take(await get());
  } catch (cause) {
    complain(cause);
  }
}

export function newMission(): void {
  unlessUnsaved(() => void bring(api.newMission));
}

export function openPath(path: string): void {
  unlessUnsaved(() => void bring(() => api.mission(path)));
}

/** Opens a file that the person chose or dropped; it has no place on our disk until it is saved. */
export function openFromComputer(file: File): void {
  unlessUnsaved(() => void bring(async () => api.readMission(file.name, await file.arrayBuffer())));
}

/** The first mission: the one of the command line, else the first example, else an empty one. */
export async function begin(): Promise<void> {
  try {
    const session = await api.session();
    set({ session });
    if (session.path === null) {
      const example = (await api.missions()).find((entry) => entry.example);
      take(example === undefined ? await api.newMission() : await api.mission(example.path));
    } else {
      await beginWith(session.path);
    }
  } catch (cause) {
    complain(cause, () => void begin());
  }
}

/** A file that cannot be read leaves an empty mission, and the sentence about it above. */
async function beginWith(path: string): Promise<void> {
  try {
    take(await api.mission(path));
  } catch (cause) {
    take(await api.newMission());
    complain(cause);
  }
}

/** Saves where the mission is from, or asks for a name. True when it is on disk. */
export async function save(): Promise<boolean> {
  const { path, revision } = useStudio.getState().file;
  if (!hasPlace(path)) {
    show("save-as");
    return false;
  }
  return write(path, revision);
}

export async function write(path: string, revision: string): Promise<boolean> {
  const { mission } = useStudio.getState();
  set({ saving: true });
  try {
    const saved = await api.saveMission(path, revision, mission);
    if (useStudio.getState().mission === mission) useStudio.getState().markSaved(saved.path, saved.revision);
    set({ banner: null, overlay: null, fileProblems: [] });
    return true;
  } catch (cause) {
    if (cause instanceof ApiError && cause.status === 409 && path === useStudio.getState().file.path) {
      conflict(path, cause.revision);
    } else {
      complain(cause);
    }
    return false;
  } finally {
    set({ saving: false });
  }
}

function conflict(path: string, revision: string): void {
  question(t("banner.conflict", { name: fileName() }), [
    ["banner.conflict-keep", () => void write(path, revision)],
    ["banner.conflict-theirs", () => void bring(() => api.mission(path))],
    ["banner.conflict-as", () => show("save-as")],
  ]);
}

/** A new name inside the workspace: null when saved, else the revision of the file that is already there. */
export async function saveAs(path: string, over: string): Promise<{ taken: string } | null> {
  const { mission } = useStudio.getState();
  try {
    const saved = await api.saveMission(path, over, mission);
    useStudio.getState().markSaved(saved.path, saved.revision);
    set({ banner: null, overlay: null, fileProblems: [] });
    return null;
  } catch (cause) {
    if (cause instanceof ApiError && cause.status === 409) return { taken: cause.revision };
    throw cause;
  }
}

export async function downloadMission(): Promise<void> {
  try {
    const { text } = await api.missionText(useStudio.getState().mission);
    download(fileName(), text, "application/xml");
  } catch (cause) {
    complain(cause);
  }
}

export function downloadProgram(): void {
  const { activeProgram, report } = useStudio.getState();
  const found = report?.programs.find((program) => program.name === activeProgram);
  if (found !== undefined) download(`${activeProgram}.lll`, found.lll, "text/plain");
}
