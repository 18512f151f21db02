/**
 * What surrounds the open mission: the session, one banner (a failure or a question, never a blocking dialog) and which sheet
 * lies over the page. The mission itself is in `useStudio`; how it is opened and saved in `opening.ts`, `open-requests.ts`
 * and `saving.ts`.
 */
import { create } from "zustand";

import type { Session } from "../api/generated";
import { whyRefused } from "../api/refusal";
import { type Key, sentence, t } from "../i18n/words";
import { freeStem } from "../model/free-name";
import { useStudio } from "../model/studio";
import { typedName } from "../model/typed-name";
import type { Problem } from "../model/types";

export interface BannerAction {
  label: string;
  run: () => void;
}

export interface Banner {
  kind: "error" | "question" | "note";
  message: string;
  help: string;
  actions: BannerAction[];
  /** Whether it answers what the user has just done, and so takes the focus. */
  takesFocus?: boolean;
}

/** Names of the sheets that can lie over the page: who draws a sheet (`sheets` of `Feature`) adds its name here. */
// eslint-disable-next-line @typescript-eslint/no-empty-object-type -- others give it its members
export interface Overlays {}

export type Overlay = keyof Overlays | null;

interface DocumentState {
  session: Session | null;
  /** False until the first mission is there. */
  ready: boolean;
  /** Whether the mission is drawn and edited before the studio is there: what the studio does waits until then. */
  ahead: boolean;
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
  ahead: false,
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

/** Closes the sheet that lies over the page. */
export function closeOverlay(): void {
  set({ overlay: null });
}

export function dismissBanner(): void {
  set({ banner: null });
}

export function putBanner(banner: Banner): void {
  set({ banner });
}

/** What can be done about a banner, which goes away with it. */
export function bannerAction(label: string, act: () => void): BannerAction {
  return {
    label,
    run: () => {
      dismissBanner();
      act();
    },
  };
}

/** Says something, with what can be done about it. */
export function note(message: string, help = "", actions: BannerAction[] = []): void {
  putBanner({ kind: "note", message, help, actions });
}

export function startSession(session: Session): void {
  set({ session });
}

/** A mission is drawn before the studio is there. */
export function drawnAhead(): void {
  set({ ahead: true });
}

/** Another mission is on its way, or no more. */
export function setOpening(opening: boolean): void {
  set({ opening });
}

export function setSaving(saving: boolean): void {
  set({ saving });
}

/** Once the page's own first mission is there: what opens or runs before would be taken for that. */
export function whenReady(): Promise<void> {
  if (useDocument.getState().ready) return Promise.resolve();
  return new Promise((resolve) => {
    const off = useDocument.subscribe(({ ready }) => {
      if (!ready) return;
      off();
      resolve();
    });
  });
}

/** A mission is there; what was said and shown of the one before goes. */
export function missionOpened(fileProblems: Problem[]): void {
  set({ ready: true, ahead: false, banner: null, overlay: null, fileProblems });
}

/** The mission that was drawn before the studio was there is the open one; what is shown around it stays. */
export function drawnMissionOpened(fileProblems: Problem[]): void {
  set({ ready: true, ahead: false, fileProblems });
}

export function missionSaved(): void {
  set({ banner: null, overlay: null, fileProblems: [] });
}

function placed({ line, message }: Problem): string {
  return line > 0 ? t("banner.line", { line, message }) : sentence(message);
}

/** Says that something failed, with a way to try again where there is one. */
export function reportError(cause: unknown, again?: () => void): void {
  const { message, help: way, problems } = whyRefused(cause);
  const help = [...problems.slice(0, 1).map(placed), way].join(" ").trim();
  const actions = again === undefined ? [] : [{ label: t("banner.retry"), run: again }];
  set({ banner: { kind: "error", message, help, actions } });
}

/** Asks, without standing in the way; each answer takes the question away. */
export function question(message: string, choices: [Key, () => void][], kind: Banner["kind"] = "question", help = "") {
  const actions = choices.map(([key, run]) => ({
    label: t(key),
    run: () => {
      run(); // first: whoever asks as soon as no question is open knows the answer then
      if (useDocument.getState().banner?.actions === actions) dismissBanner();
    },
  }));
  set({ banner: { kind, message, help, actions } });
}

/** Asks before something goes on that the user has just begun: the first answer has the focus, and Escape is none. */
export function focusQuestion(message: string, choices: [Key, () => void][], help = "") {
  question(message, choices, "question", help);
  set(({ banner }) => ({ banner: banner && { ...banner, takesFocus: true } }));
}

/** Always a .krt, whatever was typed. */
export function asMissionPath(text: string): string {
  const name = typedName(text);
  return name === "" || name.toLowerCase().endsWith(".krt") ? name : `${name}.krt`;
}

/** The name of a new mission, without its ending; one that a file or unsaved work has is given a number: `walk-2`. */
export function freeMissionName(typed: string, taken: readonly string[]): string {
  const stem = asMissionPath(typed).replace(/\.krt$/i, "");
  const used = new Set(taken.map((name) => name.toLowerCase()));
  return freeStem(stem, (name) => used.has(`${name}.krt`.toLowerCase()));
}

/** A file's name without its folders. */
export function shownName(name: string): string {
  return name.split("/").at(-1) || t("file.untitled");
}

/** The open file's name as the page shows it. */
export function fileName(): string {
  return shownName(useStudio.getState().file.name);
}
