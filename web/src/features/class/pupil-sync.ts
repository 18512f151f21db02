/**
 * The pupil's side of a class: tells it what happens here, hands the work in a moment after each change, and hears what the
 * teacher wants. It asks nothing of the studio's own Python but to read files and to list exercises.
 *
 * What cannot be handed in waits, in the browser's storage too, and goes when the class is back.
 */
import { create } from "zustand";

import { classApi, type ClassSocket, openClassSocket } from "../../api/class";
import { api, ApiError } from "../../api/client";
import type { HandMessage, PupilNewsMessage, ReportMessage, ShowArenaMessage, TurnMessage } from "../../api/generated";
import { takeToken } from "../../api/token";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import type { Mission } from "../../model/types";
import { asMissionPath, note, reportError, shownName, whenReady } from "../../session/document";
import { readExerciseLink } from "../../session/exercise-link";
import {
  remember as rememberExercise,
  setComments,
  setHandIn,
  useOpenExercise,
  workedOn,
} from "../../session/open-exercise";
import { beginMission } from "../../session/open-requests";
import { useRun } from "../../session/run";
import { endAll, listen } from "../../ui/effects";
import { readStored, writeStored } from "../../ui/browser-storage";
import { watchHash } from "../../ui/page-hash";
import { tellArena } from "./arena";
import { type Memory, type Place, placeFor, readMemory, storageName, type Waiting } from "./hand-in-memory";
import { forgetKept, leaveFiles } from "./left";
import { openLinked } from "./linked";
import { exerciseOffer, offer, openHanded, openOrOffer } from "./pupil-offers";
import { reportOf } from "./pupil-report";

const QUIET_MS = 1200;
const LONGEST_MS = 5000;
const AGAIN_MS = 4000;
const REPORT_MS = 700;

interface Classroom {
  news: PupilNewsMessage | null;
  connected: boolean;
  /** Whether everything here is in the teacher's folder. */
  kept: "yes" | "waits" | "here" | "refused";
  problem: string;
  /** The hand as it was put here, until the class says so too; null when nothing is on its way. */
  hand: boolean | null;
  /** What tells the class; what it has still to hand in outlives the page of one language. */
  sync: PupilSync | null;
}

export const useClassroom = create<Classroom>(() => ({
  news: null,
  connected: true,
  kept: "yes",
  problem: "",
  hand: null,
  sync: null,
}));

const set = useClassroom.setState;

type Said = ReportMessage | HandMessage | TurnMessage | ShowArenaMessage;

/** Whether the class still knows this pupil; else the page is the one for joining again. */
async function expectIn(): Promise<void> {
  try {
    await classApi.works();
  } catch (cause) {
    if (cause instanceof ApiError && cause.status === 403) leaveClass();
  }
}

/** Out of the class, in this browser; the work is with the class. */
function leaveClass(): void {
  takeToken("");
  window.location.reload();
}

/** A pupil's page in a class, from its beginning to its end. */
class PupilSync {
  #memory: Memory = readMemory(null);
  #socket: ClassSocket<Said> | null = null;
  /** Where the open mission is handed in, and what of it the class does not have. */
  #place: Place = { name: "", revision: "" };
  #waiting: (Waiting & { mission: Mission }) | null = null;
  #since = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #sending = false;
  /** The pupil pressed Hand in: it is said when it is done. */
  #pressed = false;
  /** The teacher is let in to edit once everything is handed in. */
  #letting = false;
  /** The name under which work of the class is opened next: it goes on where it was. */
  #goesOn = "";
  readonly #counts = { edits: 0, runs: 0 };
  /** One after the other: each goes on from what the one before remembered. */
  #hearing: Promise<void> = Promise.resolve();
  #told = "";
  #reporting: ReturnType<typeof setTimeout> | undefined;

  #recall(): void {
    this.#memory = readMemory(readStored(storageName()));
  }

  #keepMemory(change: Partial<Memory>): void {
    this.#memory = { ...this.#memory, ...change };
    // Where storage is full or denied, the work is in the page, and with the class once it answers.
    writeStored(storageName(), JSON.stringify(this.#memory));
  }

  #changed(mission: Mission): void {
    const { file } = useStudio.getState();
    const shown = shownName(file.name);
    const now = Date.now();
    if (this.#waiting === null) this.#since = now;
    this.#waiting = { shown, place: this.#place, mission, exercise: workedOn(file) };
    set({ kept: useClassroom.getState().connected ? "waits" : "here" });
    this.#later(Math.min(QUIET_MS, Math.max(0, this.#since + LONGEST_MS - now)));
  }

  #later(ms: number): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => void this.#handIn(), ms);
  }

  async #handIn(): Promise<void> {
    if (this.#waiting === null || this.#sending) return;
    const mine = this.#waiting;
    this.#sending = true;
    try {
      const { place, shown, mission, exercise } = mine;
      const kept = await classApi.handIn(place.name || shown, place.revision, mission, exercise);
      // What was changed meanwhile goes on from what is kept now.
      if (this.#place === place) this.#place = kept;
      if (this.#waiting !== null && this.#waiting !== mine && this.#waiting.place === place) this.#waiting.place = kept;
      if (this.#waiting === mine) this.#waiting = null;
      this.#keepMemory({ places: { ...this.#memory.places, [shown]: kept }, waiting: null });
      set({ kept: this.#waiting === null ? "yes" : "waits", problem: "" });
      if (this.#waiting !== null) this.#later(QUIET_MS);
      else if (this.#letting) this.#giveTurn(true);
      if (this.#waiting === null) this.#sayHandedIn(kept.name);
    } catch (cause) {
      this.#keepMemory({ waiting: mine });
      const status = cause instanceof ApiError ? cause.status : 0;
      if (status === 403) void expectIn();
      const refused = status >= 400 && status < 500 && status !== 403 && status !== 429;
      set({ kept: refused ? "refused" : "here", problem: cause instanceof Error ? cause.message : "" });
      if (this.#pressed && !refused) note(t("class.kept-here"), t("class.kept-here-help"));
      this.#later(AGAIN_MS);
    } finally {
      this.#sending = false;
    }
  }

  /** Hands in what is open now, and says so. */
  readonly #press = (): void => {
    this.#pressed = true;
    this.#changed(useStudio.getState().mission);
    this.#later(0);
  };

  #sayHandedIn(name: string): void {
    if (!this.#pressed) return;
    this.#pressed = false;
    const of = useClassroom.getState().news?.class_name ?? "";
    note(t("class.handed-in", { name, class: of }), t("class.handed-in-help"));
  }

  /** What an earlier page of this browser could not hand in. */
  #goOnWaiting(): void {
    const before = this.#memory.waiting;
    if (before === null || this.#waiting !== null) return;
    this.#waiting = { ...before, mission: before.mission as Mission };
    set({ kept: "waits" });
    this.#later(0);
  }

  readonly #openWork = async (name: string, exercise: string): Promise<void> => {
    const { bytes, revision } = await classApi.work(name);
    this.#keepMemory({ places: { ...this.#memory.places, [name]: { name, revision } } });
    this.#goesOn = name;
    if (exercise !== "") rememberExercise({ name: exercise, path: asMissionPath(name) });
    beginMission(() => api.readMission(name, bytes), name);
  };

  /** Follows the link of the address; `className` is "" while the class does not answer. */
  #follow(className: string): void {
    if (readExerciseLink(window.location.hash) === null) return;
    // Nothing else comes over what is opened now.
    if (!this.#memory.begun && className === "") this.#keepMemory({ begun: true });
    const waits = (exercise: string) => (this.#waiting ?? this.#memory.waiting)?.exercise === exercise;
    this.#hearing = this.#hearing
      .then(whenReady)
      .then(() => openLinked({ className, waits, openWork: this.#openWork }))
      .catch(reportError);
  }

  /** The first page of this pupil in this browser: goes on where the pupil was, else begins what the class does. */
  async #beginFirst(news: PupilNewsMessage): Promise<void> {
    this.#keepMemory({ begun: true, handed: news.handed, exercise: news.exercise });
    // A link says itself what is opened.
    if (readExerciseLink(window.location.hash) !== null) return;
    const [newest] = await classApi.works();
    if (newest !== undefined) await this.#openWork(newest.name, newest.exercise ?? "");
    else if (news.handed > 0) openHanded(news.handed_name);
    else if (news.exercise !== "") (await exerciseOffer(news.exercise))?.open?.();
  }

  #hear(news: PupilNewsMessage): void {
    const before = useClassroom.getState().news?.turn;
    set(({ hand }) => ({ news, connected: true, hand: hand === news.hand ? null : hand }));
    this.#hearing = this.#hearing
      .then(whenReady)
      .then(() => this.#obey(news))
      .then(() => (before === "teacher" && news.turn === "pupil" ? this.#takeBack() : undefined))
      .catch(reportError);
    this.#follow(news.class_name);
  }

  async #obey(news: PupilNewsMessage): Promise<void> {
    setComments(news.comments);
    this.#offerComment(news.comments);
    if (!this.#memory.begun) {
      await this.#beginFirst(news);
      return;
    }
    if (news.handed > this.#memory.handed) {
      this.#keepMemory({ handed: news.handed });
      openOrOffer({ kind: "handed", words: news.handed_name, open: () => openHanded(news.handed_name) });
    }
    if (news.exercise !== this.#memory.exercise) {
      this.#keepMemory({ exercise: news.exercise });
      const one = news.exercise === "" ? null : await exerciseOffer(news.exercise);
      if (one !== null) openOrOffer(one);
    }
    if (news.note > this.#memory.note) {
      this.#keepMemory({ note: news.note });
      if (news.note_text !== "") offer({ kind: "note", words: news.note_text, open: null });
    } else if (news.note < this.#memory.note) this.#keepMemory({ note: news.note });
  }

  /** A new comment is offered where the exercise that it is on, which shows it, is not open. */
  #offerComment(comments: Readonly<Record<string, string>>): void {
    const known = this.#memory.comments;
    const fresh = Object.entries(comments).find(([exercise, words]) => known[exercise] !== words);
    if (fresh === undefined && Object.keys(known).length === Object.keys(comments).length) return;
    this.#keepMemory({ comments: { ...comments } });
    if (fresh === undefined) return;
    if (workedOn(useStudio.getState().file) !== fresh[0]) offer({ kind: "comment", words: fresh[1], open: null });
  }

  /** Lets the teacher edit, once the class has what is open here; or not, or not any more. */
  letEdit(yes: boolean): void {
    if (!yes) {
      this.#giveTurn(false);
      return;
    }
    this.#letting = true;
    this.#changed(useStudio.getState().mission);
    this.#later(0);
  }

  #giveTurn(yes: boolean): void {
    this.#letting = false;
    this.#socket?.say({ type: "turn", yes });
  }

  /** What the teacher saved, as one step that can be taken back. Where something was changed here meanwhile that stays. */
  async #takeBack(): Promise<void> {
    if (this.#waiting !== null) return;
    const mine = this.#place;
    const { bytes, revision } = await classApi.work(mine.name);
    if (revision === mine.revision) return;
    const { mission } = await api.readMission(mine.name, bytes);
    if (this.#waiting !== null || this.#place !== mine) return;
    this.#place = { name: mine.name, revision };
    useStudio.getState().execute({ label: t("class.edited"), execute: () => mission });
  }

  /** Without a connection it goes when the class is back. */
  putHand(up: boolean): void {
    set({ hand: up });
    this.#socket?.say({ type: "hand", up });
  }

  #report(): void {
    this.#reporting ??= setTimeout(() => {
      this.#reporting = undefined;
      const said = reportOf(this.#counts);
      const words = JSON.stringify(said);
      if (words === this.#told) return;
      this.#told = words;
      this.#socket?.say(said);
    }, REPORT_MS);
  }

  /** The pupil goes. What the class does not have yet stays in this browser. */
  goAway(): void {
    if (this.#waiting === null && this.#memory.waiting === null) {
      leaveFiles();
      forgetKept(storageName());
    }
    leaveClass();
  }

  /** Begins; the returned function ends it. */
  start(): () => void {
    this.#recall();
    this.#socket = openClassSocket<Said, PupilNewsMessage>("pupil", {
      onOpen: () => {
        this.#told = "";
        set({ connected: true });
        this.#report();
        const { hand } = useClassroom.getState();
        if (hand !== null) this.putHand(hand);
        if (this.#waiting !== null) this.#later(0);
        else this.#goOnWaiting();
      },
      onMessage: (news) => this.#hear(news),
      onSilence: (silent) => set({ connected: !silent }),
      onLost: () => {
        set(({ kept }) => ({ connected: false, kept: kept === "waits" ? "here" : kept }));
        void expectIn();
        if (useClassroom.getState().news === null) this.#follow("");
      },
    });
    const offStudio = useStudio.subscribe((state, before) => {
      if (state.change !== before.change && state.change.kind === "open") {
        const shown = shownName(state.file.name);
        const elsewhere = state.file.path === "" || state.file.path.startsWith("example:");
        const fresh = this.#goesOn !== shown && elsewhere && !state.dirty;
        this.#goesOn = "";
        this.#place = placeFor(this.#memory, shown, fresh);
        if (state.dirty) this.#changed(state.mission);
      } else if (state.mission !== before.mission) {
        this.#counts.edits++;
        this.#changed(state.mission);
      } else if (state.file.name !== before.file.name) {
        this.#place = placeFor(this.#memory, shownName(state.file.name), false);
        this.#changed(state.mission);
      }
      this.#report();
    });
    const offRun = useRun.subscribe(({ status, name }, before) => {
      if (status === before.status) return;
      if (status === "running" && name !== before.name) this.#counts.runs++;
      this.#report();
    });
    const offGoals = useOpenExercise.subscribe(() => this.#report());
    const offArena = tellArena(
      () => useClassroom.getState().news?.looked === true,
      (arena) => this.#socket?.say({ type: "arena", arena }),
    );
    const offHiding = listen(document, { visibilitychange: () => void this.#handIn() });
    const offHash = watchHash(() => {
      const { news } = useClassroom.getState();
      if (news !== null) this.#follow(news.class_name);
    });
    setHandIn(this.#press);
    return () => {
      endAll(offStudio, offRun, offGoals, offArena, offHiding, offHash, () => setHandIn(null))();
      clearTimeout(this.#timer);
      clearTimeout(this.#reporting);
      this.#reporting = undefined;
      this.#socket?.close();
      this.#socket = null;
    };
  }
}

export function letEdit(yes: boolean): void {
  useClassroom.getState().sync?.letEdit(yes);
}

export function putHand(up: boolean): void {
  useClassroom.getState().sync?.putHand(up);
}

export function goAway(): void {
  useClassroom.getState().sync?.goAway();
}

/** Begins, or goes on in another language; the returned function ends it. */
export function keepClass(): () => void {
  const sync = useClassroom.getState().sync ?? new PupilSync();
  set({ sync });
  return sync.start();
}
