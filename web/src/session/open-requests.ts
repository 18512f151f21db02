/** What a person asks to open. Whatever would throw unsaved changes away asks first. */
import { create } from "zustand";

import { api, ApiError } from "../api/client";
import type { OrphanedJournal } from "../api/generated";
import { journalApi } from "../api/journal";
import { traceApi } from "../api/traces";
import { type Key, t } from "../i18n/words";
import { useStudio } from "../model/studio";
import type { MissionFile } from "../model/types";
import { asMissionPath, fileName, focusQuestion, question, reportError, shownName, useDocument } from "./document";
import { flush, isKept } from "./journal";
import { openLesson, useLessons } from "./lessons";
import { bringMission, bringRecording, takeLeft, whileOpening } from "./opening";
import { isRecording } from "./recordings";
import { save } from "./saving";

/** While the first mission is on its way. */
const useBeginning = create<{ beginning: Promise<void> | null }>(() => ({ beginning: null }));

/** What is asked before the first mission is there waits for it, and is not covered by it then. */
export function holdUntil(begun: Promise<void>): Promise<void> {
  const beginning = begun.finally(() => useBeginning.setState({ beginning: null }));
  useBeginning.setState({ beginning });
  return beginning;
}

/** Goes on where nothing is unsaved; else asks. `path` is what will be open then, "" for nothing that has a place. */
function unlessUnsaved(go: () => Promise<boolean>, path = ""): void {
  const { beginning } = useBeginning.getState();
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
  // The same file again: its unsaved changes are to be discarded.
  const again = path !== "" && path === file.path;
  focusQuestion(
    t("banner.unsaved", { name }),
    [
      ["banner.save", () => void save().then((saved) => saved && go())],
      again ? ["journal.discard", () => void go()] : ["banner.discard", () => void leave(go, name)],
      ["banner.cancel", () => undefined],
    ],
    t(again ? "journal.again-help" : "journal.leave-help"),
  );
}

/** Goes on from unsaved work that is in the journal, and says where it is; asks when it is not there. */
async function leave(go: () => Promise<boolean>, name: string, says = true): Promise<void> {
  await flush();
  if (!isKept()) {
    focusQuestion(t("journal.not-kept", { name }), [
      ["banner.save", () => void save().then((saved) => saved && go())],
      ["journal.discard", () => void go()],
      ["banner.cancel", () => undefined],
    ]);
    return;
  }
  if (!(await go()) || !says || useDocument.getState().banner !== null) return;
  question(t("journal.left", { name }), [], "note", t("journal.left-help"));
}

/** Opens work that was left behind, when the person asks for it. */
export function openLeft(journal: string): void {
  unlessUnsaved(async () => {
    try {
      if (await takeLeft(journal)) return true;
      reportError(new ApiError(t("journal.gone")));
    } catch (cause) {
      reportError(cause);
    }
    return false;
  });
}

/** Says that work on a new mission was left behind, which no file's name leads to, or work that cannot be opened here. */
export function offerLeft(left: readonly OrphanedJournal[]): void {
  const first = left.find(({ path, problem }) => path === "" && problem === "");
  const said = first ?? left.find(({ problem }) => problem !== "");
  if (said === undefined || useDocument.getState().banner !== null) return;
  const discard = () => void journalApi.forget(said.journal).then(offerLeft, reportError);
  if (first === undefined) {
    const choices: [Key, () => void][] = [
      ["journal.later", () => undefined],
      ["journal.discard", discard],
    ];
    question(said.problem, choices, "question", t("journal.closed-help"));
    return;
  }
  const choices: [Key, () => void][] = [
    ["journal.open", () => openLeft(first.journal)],
    ["journal.discard", discard],
    ["journal.later", () => undefined],
  ];
  question(t("journal.left", { name: shownName(first.name) }), choices);
}

/** Opens a mission that has no file yet, under the name that it is to have. */
export function beginMission(get: () => Promise<MissionFile>, name: string): void {
  unlessUnsaved(() => bringMission(async () => ({ ...(await get()), name: asMissionPath(name) })));
}

export function openPath(path: string): void {
  const go = () =>
    isRecording(path) ? bringRecording(() => traceApi.open(path)) : bringMission(() => api.mission(path));
  unlessUnsaved(go, path);
}

/**
 * Opens the mission of a lesson. From an included lesson it goes on without a question: what was done there cannot be saved in
 * its place, is in the journal, and comes back with it.
 */
export function openMissionOfLesson(path: string): void {
  const { dirty, file } = useStudio.getState();
  const fromLesson = openLesson(useLessons.getState()) !== null && file.path.startsWith("example:");
  if (useBeginning.getState().beginning === null && dirty && fromLesson && file.path !== path) {
    void leave(() => bringMission(() => api.mission(path)), fileName(), false);
  } else openPath(path);
}

/** Opens a file that the person chose or dropped; it has no place on our disk until it is saved. */
export function openFromComputer(file: File): void {
  unlessUnsaved(() => {
    if (isRecording(file.name)) return bringRecording(async () => traceApi.read(file.name, await file.arrayBuffer()));
    return bringMission(async () => api.readMission(file.name, await file.arrayBuffer()));
  });
}
