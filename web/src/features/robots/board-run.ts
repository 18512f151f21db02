/**
 * Real robots as the run that the page shows: which ones are asked for as a run, and when. From there they are a run like any
 * other (session/run), so vertices glow, tabs, code, watch and STOP work as they do there.
 *
 * A robot is shown while it has a program of the mission that is open, from the moment it runs; those with the same state of
 * the programs are one run. Only those that this page holds: it knows what they were given.
 */
import { create } from "zustand";

import { useStudio } from "../../model/studio";
import { isLive, type RunAgent, useRun } from "../../session/run";
import { type BoardsState, isMine, type SentProgram, useBoards } from "./boards";
import { setRunning } from "./state";
import type { Board } from "./wire";

/** The robots that the canvas can show. */
export function shownBoards(state: BoardsState, path: string): Board[] {
  return Object.values(state.boards).filter(
    (board) => isMine(state, board) && board.program !== "" && state.given[board.address]?.path === path,
  );
}

export function isRunning(board: Board): boolean {
  return board.phase === "open" && board.state === "running";
}

/** Whether both were given the same programs. */
export function isAlike(a: Pick<SentProgram, "mission">, b: Pick<SentProgram, "mission">): boolean {
  return (["programs", "constructors", "variables"] as const).every((part) => a.mission[part] === b.mission[part]);
}

/** The robots that are one run: those alike to the one that was given its program last of all that run. */
export function runOf(state: BoardsState, path: string): { given: SentProgram; boards: Board[] } | null {
  const shown = shownBoards(state, path);
  const running = new Set(shown.filter(isRunning).map(({ address }) => address));
  const last = Object.keys(state.given).findLast((address) => running.has(address)) ?? "";
  const given = state.given[last];
  if (given === undefined) return null;
  const alike = ({ address }: Board) => {
    const own = state.given[address];
    return own !== undefined && isAlike(own, given);
  };
  return { given, boards: shown.filter(alike) };
}

interface ShownRun {
  /** Robots of the run that was asked for last: addresses, and what each has. */
  asked: readonly (readonly [address: string, installed: string])[];
  /** Whether the page looks after robots that run. */
  kept: boolean;
}

const useShown = create<ShownRun>(() => ({ asked: [], kept: false }));

export function agentAt(address: string): RunAgent | undefined {
  const { real, watching, agents } = useRun.getState();
  const { asked } = useShown.getState();
  return real && !watching ? agents[asked.findIndex(([one]) => one === address)] : undefined;
}

function show(): void {
  const state = useBoards.getState();
  const { path } = useStudio.getState().file;
  const { status, real, watching, error, reset, robots } = useRun.getState();
  const ours = real && !watching;
  const { asked } = useShown.getState();
  if (ours && !shownBoards(state, path).some(({ address }) => asked.some(([one]) => one === address))) {
    reset();
    return;
  }
  const run = runOf(state, path);
  if (run === null) return;
  const { given, boards } = run;
  const isAsked = ({ address, installed }: Board) => asked.some(([one, has]) => one === address && has === installed);
  const all = boards.filter(isRunning).every(isAsked);
  // A run that the server refused is not asked for again and again.
  if (ours || error !== null ? all : isLive(status)) return;
  useShown.setState({ asked: boards.map(({ address, installed }) => [address, installed]) });
  robots({ mission: given.mission, path, holder: state.you, addresses: boards.map(({ address }) => address) });
}

/** From now on the page shows robots that run. */
export function keepShown(): void {
  useShown.setState({ kept: true });
}

useBoards.subscribe(({ boards, team }, before) => {
  if (!useShown.getState().kept || (boards === before.boards && team === before.team)) return;
  const running = Object.values(boards).filter(isRunning).length + Number(team?.phase === "running");
  setRunning(running);
  show();
});
useRun.subscribe(({ name }, before) => {
  if (useShown.getState().kept && name !== before.name) show();
});
useStudio.subscribe(({ file }, before) => {
  if (useShown.getState().kept && file.path !== before.file.path) show();
});
