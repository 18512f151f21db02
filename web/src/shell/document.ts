/**
 * The open mission and its file: opening, saving, downloading, and the questions that come up on the way.
 *
 * The mission itself is in `useStudio`; here is what surrounds it: the session, one banner (a failure or a question, never a
 * blocking dialog) and which panel lies over the page. Whatever would throw unsaved changes away asks first.
 */
import { create } from "zustand";

import { api, ApiError, type Session } from "../api/client";
import { rememberSecret } from "../api/again";
import { type Claimed, journalApi, type Left } from "../api/journal";
import { type Recording, traceApi } from "../api/traces";
import type { MissionFile, Problem } from "../api/types";
import { isUnsaved } from "../model/history";
import { useStudio } from "../model/studio";
import { holdParts } from "../parts/files";
import { useRun } from "../run/run";
import { type Key, sentence, t } from "../words/words";
import { download } from "./download";
import { claim, isKept, journalBefore, keepsJournal, openWith } from "./journal";
import { recover } from "./journal-records";
import { begin as play, isFromRecording, isRecording, saveRun } from "./recordings";

export interface BannerAction {
  label: string;
  run: () => void;
}

export interface Banner {
  kind: "error" | "question" | "note";
  message: string;
  help: string;
  actions: BannerAction[];
}

export type Overlay = "open" | "save-as" | "shortcuts" | "about" | "difference" | null;

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

/** Asks, without standing in the way; each answer takes the question away. */
export function question(message: string, choices: [Key, () => void][], kind: Banner["kind"] = "question", help = "") {
  const actions = choices.map(([key, run]) => ({
    label: t(key),
    run: () => {
      dismissBanner();
      run();
    },
  }));
  set({ banner: { kind, message, help, actions } });
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
  return path !== "" && !path.startsWith("example:") && !isFromRecording(path);
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

/** Opens a mission, with the work that was left on it; `journal` is the one that is wanted, "" for any. */
async function take(file: MissionFile, journal = ""): Promise<void> {
  resume(file, await claim(file.path, journal));
}

/** Opens a mission with what its journal holds, as far as that is still of use. */
function resume(file: MissionFile, claimed: Claimed | null): void {
  const found = recover(claimed?.records ?? []);
  const unsaved = found !== null && isUnsaved(found.history);
  const back = found !== null && (unsaved || found.revision === file.revision) ? found : null;
  openWith(back?.history ?? null);
  useRun.getState().reset();
  useStudio.getState().openMission(back === null ? file : { ...file, revision: back.revision }, back?.history);
  holdParts(file.parts ?? "");
  set({ ready: true, banner: null, overlay: null, fileProblems: file.problems });
  if (!unsaved) return;
  const help = t(claimed?.damaged === true ? "journal.back-damaged" : "journal.back-help");
  question(t("journal.back", { name: fileName() }), [["journal.discard", discard]], "note", help);
}

/** Away with what is not saved: the file as it is on disk, or a new one. */
function discard(): void {
  const { path } = useStudio.getState().file;
  void bring(() => (path === "" ? api.newMission() : api.mission(path)));
}

/** Opens work that was left behind; false when it is gone. */
async function takeLeft(journal: string): Promise<boolean> {
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

/** Says that work on a new mission was left behind, which no file's name leads to. */
function offerLeft(left: readonly Left[]): void {
  const [first] = left.filter((one) => one.path === "");
  if (first === undefined || useDocument.getState().banner !== null) return;
  const choices: [Key, () => void][] = [
    ["journal.open", () => unlessUnsaved(() => void takeLeft(first.journal).catch(complain))],
    ["journal.discard", () => void journalApi.forget(first.journal).then(offerLeft, complain)],
    ["journal.later", () => undefined],
  ];
  question(t("journal.left", { name: shownName(first.name) }), choices);
}

/** The studio started anew, and the page has gone on with it. */
export function sayReturned(): void {
  question(t("journal.returned"), [], "note", isKept() ? t("journal.returned-help") : t("journal.failed"));
}

/** Somebody else is where the studio was. */
export function sayStranger(): void {
  question(t("journal.stranger"), [], "error", t("journal.stranger-help"));
}

/** Opens the file on disk in place of what is open. */
export function loadFromDisk(): void {
  const { path } = useStudio.getState().file;
  void bring(() => api.mission(path));
}

async function bring(get: () => Promise<MissionFile>): Promise<void> {
  try {
    await take(await get());
  } catch (cause) {
    complain(cause);
  }
}

/** Opens the mission of a recording, and plays it. */
async function bringRecording(get: () => Promise<Recording>): Promise<void> {
  try {
    const found = await get();
    await take(found.file);
    play(found);
  } catch (cause) {
    complain(cause);
  }
}

export function newMission(): void {
  unlessUnsaved(() => void bring(api.newMission));
}

export function openPath(path: string): void {
  unlessUnsaved(
    () => void (isRecording(path) ? bringRecording(() => traceApi.open(path)) : bring(() => api.mission(path))),
  );
}

/** Opens a file that the person chose or dropped; it has no place on our disk until it is saved. */
export function openFromComputer(file: File): void {
  unlessUnsaved(() => {
    if (isRecording(file.name)) {
      void bringRecording(async () => traceApi.read(file.name, await file.arrayBuffer()));
    } else {
      void bring(async () => api.readMission(file.name, await file.arrayBuffer()));
    }
  });
}

/** What the address names, for a page that another `kitrobot` opened: null when it names nothing, "" for the folder. */
function namedInAddress(): string | null {
  return new URL(window.location.href).searchParams.get("open");
}

/** It is open: what happens to the page from now on counts more. */
function forgetNamed(): void {
  const address = new URL(window.location.href);
  address.searchParams.delete("open");
  window.history.replaceState(window.history.state, "", address);
}

/** The first mission: the one of the command line, else one of the folder. */
export async function begin(): Promise<void> {
  try {
    const said = await api.session();
    rememberSecret(said.secret);
    const named = namedInAddress();
    const session = named === null ? said : { ...said, path: named || null };
    set({ session });
    const back = await beginWhereItEnded(session);
    if (!back && session.path === null) await beginInFolder();
    else if (!back && session.path !== null) await beginWith(session.path);
    if (named !== null) forgetNamed();
    if (back) return;
    if (keepsJournal()) offerLeft(await journalApi.left());
  } catch (cause) {
    complain(cause, () => void begin());
  }
}

/** The folder's only mission; of several the person chooses; where there is none a new one begins. */
async function beginInFolder(): Promise<void> {
  const [first, ...others] = (await api.missions()).filter(({ example, problem }) => !example && problem === "");
  if (first !== undefined && others.length === 0) {
    await beginWith(first.path);
    return;
  }
  await take(await api.newMission());
  if (first !== undefined) show("open");
}

/**
 * The work of this tab before it was loaded again, else, when no mission was named, the newest that was left behind. False
 * when there is none.
 */
async function beginWhereItEnded(session: Session): Promise<boolean> {
  if (!keepsJournal()) return false;
  const before = journalBefore();
  if (before !== "" && (await takeLeft(before))) return true;
  const [newest] = session.path === null ? await journalApi.left() : [];
  return newest !== undefined && takeLeft(newest.journal);
}

/** A file that cannot be read leaves an empty mission, and the sentence about it above. */
async function beginWith(path: string): Promise<void> {
  try {
    if (isRecording(path)) {
      const found = await traceApi.open(path);
      await take(found.file);
      play(found);
    } else {
      await take(await api.mission(path));
    }
  } catch (cause) {
    await take(await api.newMission());
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

/** Shows what is different between the open mission and its file; the question stays meanwhile. */
export function showDifference(again: () => void): void {
  show("difference");
  again();
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

/** The run so far, as a recording. */
export async function saveTheRun(): Promise<void> {
  try {
    await saveRun();
  } catch (cause) {
    complain(cause);
  }
}

export function downloadProgram(): void {
  const { activeProgram, report } = useStudio.getState();
  const found = report?.programs.find((program) => program.name === activeProgram);
  if (found !== undefined) download(`${activeProgram}.lll`, found.lll, "text/plain");
}
