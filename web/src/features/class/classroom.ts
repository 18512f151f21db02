/** What a pupil's page knows of its class. */
import { create } from "zustand";

import type { PupilNewsMessage } from "../../api/generated";

/** What a pupil does in the class. */
interface ClassConnection {
  start: () => () => void;
  letEdit: (yes: boolean) => void;
  putHand: (up: boolean) => void;
  goAway: () => void;
}

/** Whether everything here is in the teacher's folder: `here` waits for the class to answer. */
type HandInState = "yes" | "waits" | "here" | "refused";

interface Classroom {
  news: PupilNewsMessage | null;
  connected: boolean;
  kept: HandInState;
  problem: string;
  /** The hand as it was put here, until the class says so too; null when nothing is on its way. */
  hand: boolean | null;
  /** What tells the class; what it has still to hand in outlives the page of one language. */
  connection: ClassConnection | null;
}

export const useClassroom = create<Classroom>(() => ({
  news: null,
  connected: true,
  kept: "yes",
  problem: "",
  hand: null,
  connection: null,
}));

const set = useClassroom.setState;

export function setNews(news: PupilNewsMessage): void {
  set(({ hand }) => ({ news, connected: true, hand: hand === news.hand ? null : hand }));
}

export function setConnected(connected: boolean): void {
  set({ connected });
}

/** The line to the class broke off: what waits is kept here meanwhile. */
export function loseConnection(): void {
  set(({ kept }) => ({ connected: false, kept: kept === "waits" ? "here" : kept }));
}

export function setKept(kept: HandInState, problem?: string): void {
  set(problem === undefined ? { kept } : { kept, problem });
}

export function setHand(hand: boolean): void {
  set({ hand });
}

export function setConnection(connection: ClassConnection): void {
  set({ connection });
}
