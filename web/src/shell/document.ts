/**
 * The open mission and its file: opening, saving, downloading, and the questions that come up on the way.
 *
 * The mission itself is in `useStudio`; here is what surrounds it: the session, one banner (a failure or a question, never a
 * blocking dialog) and which panel lies over the page. Whatever would throw unsaved changes away asks first.
 */
import { create } from "zustand";

import { api, ApiError, type Saved, type Session } from "../api/client";
import { type Claimed, journalApi, type Left } from "../api/journal";
import { type Recording, traceApi } from "../api/traces";
import type { Mission, MissionFile, Problem } from "../api/types";
import { isUnsaved } from "../model/history";
import { useStudio } from "../model/studio";
import { holdParts } from "../parts/files";
import { useRun } from "../run/run";
import { type Key, sentence, t } from "../words/words";
import { claim, flush, isKept, openWith } from "./journal";
import { recover } from "./journal-records";
import { begin as play, isFromRecording, isRecording } from "./recordings";

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
  /** Whether another mission is on its way. */
  opening: boolean;
  banner: Banner | null;
  overlay: Overlay;
  /** What was wrong with the file itself when it was read; it goes away with the next save. */
  fileProblems: Problem[];
}

export const useDocument = create<DocumentState>(() => ({
  session: null,
  ready: false,
  saving: false,
  opening: false,
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

/** Says that changes are in no journal at the moment: what is not saved would be lost with the page. */
export function complainOfJournal(cause: unknown, again: () => void): void {
  const why = cause instanceof ApiError ? [cause.message, cause.help] : [];
  const choices: [Key, () => void][] = [
    ["banner.save", () => void save()],
    ["banner.retry", again],
  ];
  question(t("journal.failed"), choices, "error", [...why, t("journal.failed-help")].join(" "));
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

/** While the first mission is on its way. */
let beginning: Promise<void> | null = null;

/** What is asked before the first mission is there waits for it, and is not covered by it then. */
export function holdUntil(begun: Promise<void>): Promise<void> {
  beginning = begun.finally(() => {
    beginning = null;
  });
  return beginning;
}

/** Goes on where nothing is unsaved; else asks. `path` is what will be open then, "" for nothing that has a place. */
function unlessUnsaved(go: () => Promise<boolean>, path = ""): void {
  if (beginning !== null) {
    void whileOpening(beginning.then(() => unlessUnsaved(go, path)));
    return;
  }
  const { dirty, file } = useStudio.getState();
  if (!dirty) {
    void go();
    return;
  }
  const name = fileName();
  // The file in the place of its own changes: they are what the person wants to be rid of.
  const again = path !== "" && path === file.path;
  question(
    t("banner.unsaved", { name }),
    [
      ["banner.save", () => void save().then((saved) => saved && go())],
      again ? ["journal.discard", () => void go()] : ["banner.discard", () => void leave(go, name)],
      ["banner.cancel", () => undefined],
    ],
    "question",
    t(again ? "journal.again-help" : "journal.leave-help"),
  );
}

/** Goes on from unsaved work that is in the journal, and says where it is; asks once more when it is not there. */
async function leave(go: () => Promise<boolean>, name: string): Promise<void> {
  await flush();
  if (!isKept()) {
    question(
      t("journal.not-kept", { name }),
      [
        ["banner.save", () => void save().then((saved) => saved && go())],
        ["journal.discard", () => void go()],
        ["banner.cancel", () => undefined],
      ],
      "error",
    );
    return;
  }
  if (!(await go()) || useDocument.getState().banner !== null) return;
  question(t("journal.left", { name }), [], "note", t("journal.left-help"));
}

/** Opens a mission, with the work that was left on it; `journal` is the one that is wanted, "" for any. */
export async function take(file: MissionFile, journal = ""): Promise<void> {
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

/** Opens work that was left behind, when the person asks for it. */
export function openLeft(journal: string): void {
  unlessUnsaved(async () => {
    try {
      if (await takeLeft(journal)) return true;
      complain(new ApiError(t("journal.gone")));
    } catch (cause) {
      complain(cause);
    }
    return false;
  });
}

/** Says that work on a new mission was left behind, which no file's name leads to. */
export function offerLeft(left: readonly Left[]): void {
  const [first] = left.filter((one) => one.path === "");
  if (first === undefined || useDocument.getState().banner !== null) return;
  const choices: [Key, () => void][] = [
    ["journal.open", () => openLeft(first.journal)],
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
  void bringMission(() => api.mission(path));
}

let underWay = 0;

async function whileOpening<T>(work: Promise<T>): Promise<T> {
  underWay++;
  set({ opening: true });
  try {
    return await work;
  } finally {
    underWay--;
    set({ opening: underWay > 0 });
  }
}

/** True when what `get` gives is open; a failure is told, and leaves open what is open. */
function bring<T>(get: () => Promise<T>, open: (found: T) => Promise<void>): Promise<boolean> {
  return whileOpening(
    get()
      .then(open)
      .then(
        () => true,
        (cause: unknown) => {
          complain(cause);
          return false;
        },
      ),
  );
}

const bringMission = (get: () => Promise<MissionFile>) => bring(get, take);

/** Opens the mission of a recording, and plays it. */
const bringRecording = (get: () => Promise<Recording>) =>
  bring(get, async (found) => {
    await take(found.file);
    play(found);
  });

export function newMission(): void {
  unlessUnsaved(() => bringMission(api.newMission));
}

export function openPath(path: string): void {
  const go = () =>
    isRecording(path) ? bringRecording(() => traceApi.open(path)) : bringMission(() => api.mission(path));
  unlessUnsaved(go, path);
}

/** Opens a file that the person chose or dropped; it has no place on our disk until it is saved. */
export function openFromComputer(file: File): void {
  unlessUnsaved(() => {
    if (isRecording(file.name)) return bringRecording(async () => traceApi.read(file.name, await file.arrayBuffer()));
    return bringMission(async () => api.readMission(file.name, await file.arrayBuffer()));
  });
}

/** Saves where the mission is from, or asks for a name. True when it is on disk. */
export async function save(): Promise<boolean> {
  // One after another: the next needs the revision that this one gives.
  while (writing !== null) await writing;
  const { path, revision } = useStudio.getState().file;
  if (!hasPlace(path)) {
    show("save-as");
    return false;
  }
  return write(path, revision);
}

/** Whether it was said that the folder knows no locks: once is enough. */
let toldOfLocks = false;

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
  set({ banner: null, overlay: null, fileProblems: [] });
  if (locked !== false || toldOfLocks) return;
  toldOfLocks = true;
  question(t("disk.no-locks"), [], "note", t("disk.no-locks-help"));
}

/** The save that is on its way. */
let writing: Promise<boolean> | null = null;

export async function write(path: string, revision: string): Promise<boolean> {
  const mine = writeNow(path, revision).finally(() => {
    if (writing === mine) writing = null;
  });
  writing = mine;
  return mine;
}

async function writeNow(path: string, revision: string): Promise<boolean> {
  const { mission, file } = useStudio.getState();
  set({ saving: true });
  try {
    return written(await api.saveMission(path, revision, mission), mission, file);
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
  const { mission, file } = useStudio.getState();
  try {
    written(await api.saveMission(path, over, mission), mission, file);
    return null;
  } catch (cause) {
    if (cause instanceof ApiError && cause.status === 409) return { taken: cause.revision };
    throw cause;
  }
}
