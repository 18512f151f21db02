/** What can be done with real robots, each as one function. */
import { useStudio } from "../../model/studio";
import { reveal } from "../../session/actions";
import { openDock } from "../../session/dock";
import { useRun } from "../../session/run";
import {
  forgetAddress,
  forgetRefusal,
  forgetSteps,
  isMine,
  kitFor,
  networkAddress,
  placesOf,
  programFor,
  rememberAddress,
  type SentProgram,
  setSentProgram,
  useBoards,
} from "./boards";
import { withKit } from "./kits";
import { agentAt, isAlike, keepShown } from "./board-run";
import { send } from "./socket";
import type { Board } from "./wire";

/** What is open here, for the robot at that address. */
function given(address: string): SentProgram {
  const { mission, file, activeProgram } = useStudio.getState();
  const names = mission.programs.map(({ name }) => name);
  const state = useBoards.getState();
  const program = programFor(state, address, names, activeProgram);
  return { path: file.path, program, kit: kitFor(state, address), mission };
}

function give(address: string): SentProgram {
  keepShown();
  const what = given(address);
  setSentProgram(address, what);
  return what;
}

export function connectBoard(address: string): void {
  send({ type: "connect", address, ...give(address) });
}

export function disconnectBoard(address: string): void {
  send({ type: "forget", address });
}

/**
 * `way`: what else may be done for it, when the robot refused before. It is asked first what the robot is built of, where
 * nobody has said it.
 */
export function sendTo(address: string, then: "held" | "free" | "ready", way: Board["way"] = ""): void {
  withKit(address, () => sendNow(address, then, way));
}

function sendNow(address: string, then: "held" | "free" | "ready", way: Board["way"]): void {
  if (then === "held") takeCanvas();
  send({ type: "send", address, then, replace: way === "replace", fresh: way === "fresh", ...give(address) });
}

/** Puts the program on the robot that tries its parts one by one. */
export function beginBench(address: string, way: Board["way"] = ""): void {
  withKit(address, () => benchNow(address, way));
}

function benchNow(address: string, way: Board["way"]): void {
  keepShown();
  const { path, program, kit, mission } = given(address);
  // What it had before is on it no more.
  setSentProgram(address, null);
  send({ type: "bench", address, path, program, kit, mission, replace: way === "replace" });
}

/** Does that step; null ends the one that is done. */
export function tryStep(address: string, step: number | null): void {
  send({ type: "try", address, step });
}

/** No more parts are tried; the robot stands. */
export function endBench(address: string): void {
  stopBoard(address);
  forgetSteps(address);
}

/** A robot takes the canvas from a simulated run. */
function takeCanvas(): void {
  const { real, watching, stop } = useRun.getState();
  if (!real || watching) stop();
}

/** Whether the robot has what is drawn here now. */
export function isCurrent(address: string): boolean {
  const { boards, given: all } = useBoards.getState();
  const [board, was] = [boards[address], all[address]];
  if (board?.phase !== "open" || was === undefined || board.program === "") return false;
  const now = given(address);
  return isAlike(now, was) && now.program === board.program && now.path === was.path && now.kit === was.kit;
}

/** Runs what is drawn here on that robot: sends it first, unless the robot has it. */
export function runOn(address: string, held = true): void {
  if (!isCurrent(address)) {
    sendTo(address, held ? "held" : "free");
    return;
  }
  takeCanvas();
  forgetRefusal(address);
  send({ type: "start", address, held });
}

/** On every robot that this page talks with; on the only one there is, it begins to. */
export function runOnAll(): void {
  const state = useBoards.getState();
  const places = placesOf(state);
  const mine = places.filter(({ board }) => board !== null && isMine(state, board) && board.phase !== "sending");
  const [only] = places;
  if (mine.length > 0) for (const { address } of mine) runOn(address);
  else if (only !== undefined && places.length === 1 && only.board === null) runOn(only.address);
}

export function stopBoard(address: string): void {
  send({ type: "stop", address });
}

/** Shows its variables and sensors. */
export function watchBoard(address: string): void {
  const agent = agentAt(address);
  if (agent !== undefined) {
    useStudio.getState().setActiveProgram(agent.program);
    useRun.getState().selectAgent(agent.name, agent.program);
  }
  openDock("watch-panel");
}

export function cancelSending(address: string): void {
  send({ type: "cancel", address });
}

export function identify(address: string): void {
  send({ type: "identify", address });
}

/** Adds an address on the network and greets the robot there; false when it is no address. */
export function addAddress(text: string): boolean {
  const address = networkAddress(text);
  if (address === null) return false;
  rememberAddress(address);
  connectBoard(address);
  return true;
}

export function removeAddress(address: string): void {
  forgetAddress(address);
  if (useBoards.getState().boards[address] !== undefined) disconnectBoard(address);
}

/** To the vertex where the robot stopped by itself. */
export function goToFault(address: string): void {
  const fault = useBoards.getState().boards[address]?.fault;
  if (fault !== null && fault !== undefined && fault.vertex !== "") reveal(fault.program, [fault.vertex]);
}
