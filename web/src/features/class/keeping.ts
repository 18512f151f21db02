/**
 * The pupil's side of a class: tells it what happens here, hands the work in a moment after each change, and hears what the
 * teacher wants. It asks nothing of the studio's own Python but to read files and to list exercises.
 *
 * What cannot be handed in waits, in the browser's storage too, and goes when the class is back.
 */
import { create } from "zustand";

import { type ClassSocket, classApi, openClassSocket } from "../../api/class";
import { api, ApiError } from "../../api/client";
import { exerciseApi } from "../../api/exercises";
import type { HandMessage, PupilNewsMessage, ReportMessage, ShowArenaMessage, TurnMessage } from "../../api/generated";
import { inPage } from "../../api/line";
import { pupilName, takeToken } from "../../api/token";
import { useStudio } from "../../model/studio";
import { t } from "../../i18n/words";
import { text } from "../../model/texts";
import type { Mission } from "../../model/types";
import { complain, shownName, useDocument } from "../../session/document";
import { remember as rememberExercise, useOpenExercise } from "../../session/open-exercise";
import { beginMission, openPath } from "../../session/open-requests";
import { useRun } from "../../session/run";
import { tellArena } from "./arena";
import { type Memory, type Place, placeFor, readMemory } from "./kept";
import { leaveFiles } from "./left";

const QUIET_MS = 1200;
const LONGEST_MS = 5000;
const AGAIN_MS = 4000;
const REPORT_MS = 700;
const KEY = "kitrobot.class.kept";

export interface Offer {
  kind: "handed" | "exercise" | "note";
  words: string;
  open: (() => void) | null;
}

interface Classroom {
  news: PupilNewsMessage | null;
  connected: boolean;
  /** Whether everything here is in the teacher's folder. */
  kept: "yes" | "waits" | "here" | "refused";
  problem: string;
  offers: readonly Offer[];
  /** The hand as it was put here, until the class says so too; null when nothing is on its way. */
  hand: boolean | null;
}

export const useClassroom = create<Classroom>(() => ({
  news: null,
  connected: true,
  kept: "yes",
  problem: "",
  offers: [],
  hand: null,
}));

const set = useClassroom.setState;

let memory: Memory = readMemory(null);
type Said = ReportMessage | HandMessage | TurnMessage | ShowArenaMessage;
let socket: ClassSocket<Said> | null = null;
/** Where the open mission is handed in, and what of it the class does not have. */
let place: Place = { name: "", revision: "" };
let waiting: { shown: string; place: Place; mission: Mission } | null = null;
let since = 0;
let timer: ReturnType<typeof setTimeout> | undefined;
let sending = false;
/** The teacher is let in to edit once everything is handed in. */
let letting = false;
/** The name under which work of the class is opened next: it goes on where it was. */
let goesOn = "";
const counts = { edits: 0, runs: 0 };

function storageName(): string {
  // Of another pupil at this computer nothing is used.
  return `${KEY}.${pupilName()}`;
}

function recall(): void {
  try {
    memory = readMemory(localStorage.getItem(storageName()));
  } catch {
    memory = readMemory(null);
  }
}

function keepMemory(change: Partial<Memory>): void {
  memory = { ...memory, ...change };
  try {
    localStorage.setItem(storageName(), JSON.stringify(memory));
  } catch {
    // Storage is full or denied: the work is in the page, and with the class once it answers.
  }
}

// -- handing in

function changed(mission: Mission): void {
  const shown = shownName(useStudio.getState().file.name);
  const now = Date.now();
  if (waiting === null) since = now;
  waiting = { shown, place, mission };
  set({ kept: useClassroom.getState().connected ? "waits" : "here" });
  later(Math.min(QUIET_MS, Math.max(0, since + LONGEST_MS - now)));
}

function later(ms: number): void {
  clearTimeout(timer);
  timer = setTimeout(() => void handIn(), ms);
}

async function handIn(): Promise<void> {
  if (waiting === null || sending) return;
  const mine = waiting;
  sending = true;
  try {
    const kept = await classApi.handIn(mine.place.name || mine.shown, mine.place.revision, mine.mission);
    // What was changed meanwhile goes on from what is kept now.
    if (place === mine.place) place = kept;
    if (waiting !== null && waiting !== mine && waiting.place === mine.place) waiting.place = kept;
    if (waiting === mine) waiting = null;
    keepMemory({ places: { ...memory.places, [mine.shown]: kept }, waiting: null });
    set({ kept: waiting === null ? "yes" : "waits", problem: "" });
    if (waiting !== null) later(QUIET_MS);
    else if (letting) giveTurn(true);
  } catch (cause) {
    keepMemory({ waiting: mine });
    const status = cause instanceof ApiError ? cause.status : 0;
    if (status === 403) void expectIn();
    const refused = status >= 400 && status < 500 && status !== 403 && status !== 429;
    set({ kept: refused ? "refused" : "here", problem: cause instanceof Error ? cause.message : "" });
    later(AGAIN_MS);
  } finally {
    sending = false;
  }
}

/** What an earlier page of this browser could not hand in. */
function goOnWaiting(): void {
  const before = memory.waiting;
  if (before === null || waiting !== null) return;
  waiting = { shown: before.shown, place: before.place, mission: before.mission as Mission };
  set({ kept: "waits" });
  later(0);
}

// -- what the teacher wants

function offer(one: Offer): void {
  set(({ offers }) => ({ offers: [...offers.filter(({ kind }) => kind !== one.kind), one] }));
}

export function done(one: Offer): void {
  set(({ offers }) => ({ offers: offers.filter((other) => other !== one) }));
}

/** Opens it where nothing is unsaved, else offers it. */
function openOrOffer(one: Offer): void {
  if (one.open !== null && !useStudio.getState().dirty) one.open();
  else offer(one);
}

function openHanded(name: string): void {
  beginMission(async () => api.readMission(`${name}.krt`, (await classApi.handed()).bytes), name);
}

async function openWork(name: string): Promise<void> {
  const { bytes, revision } = await classApi.work(name);
  keepMemory({ places: { ...memory.places, [name]: { name, revision } } });
  goesOn = name;
  beginMission(() => api.readMission(name, bytes), name);
}

async function exerciseOffer(name: string): Promise<Offer | null> {
  if (inPage()) await fetchExercise(name);
  const found = (await exerciseApi.all()).find((one) => one.name === name);
  if (found === undefined || found.goals.length === 0) return null;
  const open = () => {
    rememberExercise({ name, path: found.start });
    if (useStudio.getState().file.path !== found.start) openPath(found.start);
  };
  return { kind: "exercise", words: text(found.label, name), open };
}

/** Gives the files of the exercise, where they are the teacher's own, to the studio in this page. */
async function fetchExercise(name: string): Promise<void> {
  const files = await classApi.exercise();
  if (files.byteLength > 0) await exerciseApi.keep(name, files);
}

/** The first page of this pupil in this browser: goes on where the pupil was, else begins what the class does. */
async function beginFirst(news: PupilNewsMessage): Promise<void> {
  keepMemory({ begun: true, handed: news.handed, exercise: news.exercise });
  const [newest] = await classApi.works();
  if (newest !== undefined) await openWork(newest.name);
  else if (news.handed > 0) openHanded(news.handed_name);
  else if (news.exercise !== "") (await exerciseOffer(news.exercise))?.open?.();
}

/** Once the page's own first mission is there: what opens before would be taken for that. */
function whenReady(): Promise<void> {
  return new Promise((resolve) => {
    if (useDocument.getState().ready) resolve();
    const off = useDocument.subscribe(({ ready }) => {
      if (!ready) return;
      off();
      resolve();
    });
  });
}

/** One after the other: each goes on from what the one before remembered. */
let hearing: Promise<void> = Promise.resolve();

function hear(news: PupilNewsMessage): void {
  const before = useClassroom.getState().news?.turn;
  set(({ hand }) => ({ news, connected: true, hand: hand === news.hand ? null : hand }));
  hearing = hearing
    .then(whenReady)
    .then(() => obey(news))
    .then(() => (before === "teacher" && news.turn === "pupil" ? takeBack() : undefined))
    .catch(complain);
}

async function obey(news: PupilNewsMessage): Promise<void> {
  if (!memory.begun) {
    await beginFirst(news);
    return;
  }
  if (news.handed > memory.handed) {
    keepMemory({ handed: news.handed });
    openOrOffer({ kind: "handed", words: news.handed_name, open: () => openHanded(news.handed_name) });
  }
  if (news.exercise !== memory.exercise) {
    keepMemory({ exercise: news.exercise });
    const one = news.exercise === "" ? null : await exerciseOffer(news.exercise);
    if (one !== null) openOrOffer(one);
  }
  if (news.note > memory.note) {
    keepMemory({ note: news.note });
    if (news.note_text !== "") offer({ kind: "note", words: news.note_text, open: null });
  } else if (news.note < memory.note) keepMemory({ note: news.note });
}

/** Lets the teacher edit, once the class has what is open here; or not, or not any more. */
export function letEdit(yes: boolean): void {
  if (!yes) {
    giveTurn(false);
    return;
  }
  letting = true;
  changed(useStudio.getState().mission);
  later(0);
}

function giveTurn(yes: boolean): void {
  letting = false;
  socket?.say({ type: "turn", yes });
}

/** What the teacher saved, as one step that can be taken back. Where something was changed here meanwhile that stays. */
async function takeBack(): Promise<void> {
  if (waiting !== null) return;
  const mine = place;
  const { bytes, revision } = await classApi.work(mine.name);
  if (revision === mine.revision) return;
  const { mission } = await api.readMission(mine.name, bytes);
  if (waiting !== null || place !== mine) return;
  place = { name: mine.name, revision };
  useStudio.getState().execute({ label: t("class.edited"), execute: () => mission });
}

/** Without a connection it goes when the class is back. */
export function putHand(up: boolean): void {
  set({ hand: up });
  socket?.say({ type: "hand", up });
}

// -- reports

let told = "";
let reporting: ReturnType<typeof setTimeout> | undefined;

function report(): void {
  reporting ??= setTimeout(() => {
    reporting = undefined;
    const { file } = useStudio.getState();
    const { open, goals } = useOpenExercise.getState();
    const said: ReportMessage = {
      type: "report",
      running: useRun.getState().status === "running",
      ...counts,
      file: shownName(file.name).slice(0, 200),
      exercise: open?.name ?? "",
      goals: open === null ? [] : goals.slice(0, 100).map(({ reached, why }) => ({ reached, why: why.slice(0, 500) })),
    };
    const words = JSON.stringify(said);
    if (words === told) return;
    told = words;
    socket?.say(said);
  }, REPORT_MS);
}

/** Whether the class still knows this pupil; else the page is the one for joining again. */
async function expectIn(): Promise<void> {
  try {
    await classApi.works();
  } catch (cause) {
    if (cause instanceof ApiError && cause.status === 403) leaveClass();
  }
}

/** The pupil goes. What the class does not have yet stays in this browser. */
export function goAway(): void {
  if (waiting === null && memory.waiting === null) leaveFiles();
  leaveClass();
}

/** Out of the class, in this browser; the work is with the class. */
function leaveClass(): void {
  takeToken("");
  window.location.reload();
}

/** Begins; the returned function ends it. */
export function keepClass(): () => void {
  recall();
  socket = openClassSocket<Said, PupilNewsMessage>("pupil", {
    onOpen: () => {
      told = "";
      set({ connected: true });
      report();
      const { hand } = useClassroom.getState();
      if (hand !== null) putHand(hand);
      if (waiting !== null) later(0);
      else goOnWaiting();
    },
    onMessage: hear,
    onSilence: (silent) => set({ connected: !silent }),
    onLost: () => {
      set(({ kept }) => ({ connected: false, kept: kept === "waits" ? "here" : kept }));
      void expectIn();
    },
  });
  const offStudio = useStudio.subscribe((state, before) => {
    if (state.change !== before.change && state.change.kind === "open") {
      const shown = shownName(state.file.name);
      const elsewhere = state.file.path === "" || state.file.path.startsWith("example:");
      const fresh = goesOn !== shown && elsewhere && !state.dirty;
      goesOn = "";
      place = placeFor(memory, shown, fresh);
      if (state.dirty) changed(state.mission);
    } else if (state.mission !== before.mission) {
      counts.edits++;
      changed(state.mission);
    } else if (state.file.name !== before.file.name) {
      place = placeFor(memory, shownName(state.file.name), false);
      changed(state.mission);
    }
    report();
  });
  const offRun = useRun.subscribe(({ status, name }, before) => {
    if (status === before.status) return;
    if (status === "running" && name !== before.name) counts.runs++;
    report();
  });
  const offGoals = useOpenExercise.subscribe(report);
  const offArena = tellArena(
    () => useClassroom.getState().news?.looked === true,
    (arena) => socket?.say({ type: "arena", arena }),
  );
  const hide = () => void handIn();
  document.addEventListener("visibilitychange", hide);
  return () => {
    offStudio();
    offRun();
    offGoals();
    offArena();
    document.removeEventListener("visibilitychange", hide);
    clearTimeout(timer);
    clearTimeout(reporting);
    reporting = undefined;
    socket?.close();
    socket = null;
  };
}
