/**
 * The real robots as the page knows them: ports, robots that a page of this studio talks with, and what was chosen for each.
 *
 * The server tells; this only keeps. A robot's message is whole each time. Which program is to go to which robot, and the
 * addresses on the network that were typed, are remembered in this browser. Left to others: the socket (`socket.ts`), what can
 * be done (`acts.ts`), the run that the canvas shows (`board-run.ts`).
 */
import { create } from "zustand";

import type { WhyRefused } from "../../api/refusal";
import { plainDigits, readWhole } from "../../i18n/numbers";
import type { Mission } from "../../model/types";
import { parseStored, readStored, writeStored } from "../../ui/browser-storage";
import type { Board, BoardsMessage, Port, Steps, Team } from "./wire";

/** What this page sent or greeted a robot with: later edits do not reach it. */
export interface SentProgram {
  path: string;
  program: string;
  /** What the robot is built of; "" as its own file says. */
  kit: string;
  mission: Mission;
}

export interface BoardsState {
  /** By what name the server knows this page; "" without a connection. */
  you: string;
  /** By which it shows that ports of this computer are its own; "" without a connection. */
  key: string;
  /** Why there is no connection to the server, or why it does not want one; null when all is well. */
  barred: WhyRefused | null;
  /** null until the server has looked. */
  ports: Port[] | null;
  boards: Record<string, Board>;
  /** address → what can be tried of the robot there, while its parts are tried. */
  steps: Record<string, Steps>;
  /** address → what the server last refused about it. */
  refused: Record<string, WhyRefused>;
  given: Record<string, SentProgram>;
  /** address → program that is to go there. */
  chosen: Record<string, string>;
  /** address → kit that the robot there is built of, "" for what was chosen last. */
  kits: Record<string, string>;
  /** Addresses on the network. */
  typed: string[];
  /** Agent of a mission, as `bodyKey` names it → address of the board that is its body. */
  bodies: Record<string, string>;
  /** The team of this studio as it stands; null before there was one. */
  team: Team | null;
}

const KEY = "kitrobot.robots";
const MOST_KEPT = 50;
export const MOST_ADDRESS = 200;
const NETWORK = /^(?:socket|rfc2217):\/\/(?:\[[0-9a-f:.]+\]|[^\s/:@?#[\]]+):(\d{1,5})\/?$/i;

/** An address on the network as it is asked for, or null when it is none: `host:port` is a socket. */
export function networkAddress(text: string): string | null {
  const trimmed = plainDigits(text).trim();
  const whole = trimmed.includes("://") ? trimmed : `socket://${trimmed}`;
  const port = readWhole(NETWORK.exec(whole)?.[1] ?? "") ?? 0;
  return port >= 1 && port <= 65535 && whole.length <= MOST_ADDRESS ? whole : null;
}

type Kept = Pick<BoardsState, "chosen" | "kits" | "typed" | "bodies">;

/** The last entries of what was remembered that are texts. */
function texts(found: unknown): Record<string, string> {
  if (typeof found !== "object" || found === null) return {};
  const entries = Object.entries(found).filter((one): one is [string, string] => typeof one[1] === "string");
  return Object.fromEntries(entries.slice(-MOST_KEPT));
}

/** What was remembered, as far as it makes sense. */
export function readKept(text: string | null): Kept {
  const kept: Kept = { chosen: {}, kits: {}, typed: [], bodies: {} };
  const found = parseStored(text);
  if (typeof found !== "object" || found === null) return kept;
  const { chosen, kits, typed, bodies } = found as Partial<Record<keyof Kept, unknown>>;
  kept.chosen = texts(chosen);
  kept.kits = texts(kits);
  kept.bodies = texts(bodies);
  if (Array.isArray(typed)) {
    kept.typed = typed
      .filter((one): one is string => typeof one === "string" && networkAddress(one) !== null)
      .slice(-MOST_KEPT);
  }
  return kept;
}

export const NOBODY: Pick<BoardsState, "you" | "key" | "ports" | "boards" | "team"> = {
  you: "",
  key: "",
  ports: null,
  boards: {},
  team: null,
};

export const useBoards = create<BoardsState>(() => ({
  ...NOBODY,
  barred: null,
  steps: {},
  refused: {},
  given: {},
  ...readKept(readStored(KEY)),
}));

useBoards.subscribe(({ chosen, kits, typed, bodies }, before) => {
  if (chosen === before.chosen && kits === before.kits && typed === before.typed && bodies === before.bodies) return;
  writeStored(KEY, JSON.stringify({ chosen, kits, typed, bodies }));
});

/** Changes what is known of robots. */
const set = useBoards.setState;

/** The connection ended: refused before it began, or broken. */
export function boardsLost(why: WhyRefused): void {
  set((state) => ({ ...NOBODY, given: {}, barred: state.barred ?? why }));
}

export function boardsConnecting(): void {
  set({ barred: null });
}

export function takeMessage(message: BoardsMessage): void {
  set((state) => applyMessage(state, message));
}

/** That robot is given this, or with null nothing that we know; what it refused before holds no more. */
export function setSentProgram(address: string, given: SentProgram | null): void {
  set((state) => {
    const others = without(state.given, address);
    // The newest stands last.
    return {
      given: given === null ? others : { ...others, [address]: given },
      refused: without(state.refused, address),
    };
  });
}

export function forgetRefusal(address: string): void {
  set(({ refused }) => ({ refused: without(refused, address) }));
}

export function forgetSteps(address: string): void {
  set(({ steps }) => ({ steps: without(steps, address) }));
}

export function chooseProgram(address: string, program: string): void {
  set(({ chosen }) => ({ chosen: { ...without(chosen, address), [address]: program } }));
}

/** The next robot is taken for one of the same kit. */
export function setKit(address: string, kit: string): void {
  set(({ kits }) => ({ kits: { ...without(without(kits, address), ""), [address]: kit, "": kit } }));
}

export function rememberAddress(address: string): void {
  set(({ typed }) => ({ typed: [...typed.filter((one) => one !== address), address] }));
}

export function forgetAddress(address: string): void {
  set(({ typed }) => ({ typed: typed.filter((one) => one !== address) }));
  forgetRefusal(address);
}

export function setBodies(change: (bodies: BoardsState["bodies"]) => BoardsState["bodies"]): void {
  set(({ bodies }) => ({ bodies: change(bodies) }));
}

export function without<Value>(record: Record<string, Value>, key: string): Record<string, Value> {
  if (!(key in record)) return record;
  return Object.fromEntries(Object.entries(record).filter(([one]) => one !== key));
}

/** What a message of the server changes. */
export function applyMessage(state: BoardsState, message: BoardsMessage): Partial<BoardsState> {
  switch (message.type) {
    case "welcome":
      return { you: message.you, key: message.key, barred: null };
    case "ports":
      return { ports: message.ports };
    case "board":
      return { boards: { ...state.boards, [message.address]: message } };
    case "steps":
      return { steps: { ...state.steps, [message.address]: message } };
    case "team":
      return { team: message };
    case "gone":
      return {
        boards: without(state.boards, message.address),
        given: without(state.given, message.address),
        steps: without(state.steps, message.address),
      };
    case "refused": {
      const { message: said, help, problems } = message;
      const refusal = { message: said, help, problems };
      if (message.address === "") return { barred: refusal };
      return { refused: { ...state.refused, [message.address]: refusal } };
    }
  }
}

/** One line of the panel: a robot, or a place where one may be. */
export interface Place {
  address: string;
  name: string;
  description: string;
  /** The page with MicroPython for it, "" where none is known. */
  firmware: string;
  /** null while no page talks with it. */
  board: Board | null;
}

/** Robots and ports as they are listed: the ports in the server's order, then what is on the network or was pulled out. */
export function placesOf({ ports, boards, typed }: Pick<BoardsState, "ports" | "boards" | "typed">): Place[] {
  const listed = ports ?? [];
  const found: Place[] = listed.map((port) => ({ ...port, board: boards[port.address] ?? null }));
  const there = new Set(listed.map(({ address }) => address));
  const others = [...typed, ...Object.keys(boards).filter((address) => !typed.includes(address))];
  for (const address of others) {
    if (there.has(address)) continue;
    const board = boards[address] ?? null;
    found.push({
      address,
      name: board?.name ?? address.replace(/^\w+:\/\//, ""),
      description: "",
      firmware: "",
      board,
    });
  }
  return found;
}

/** The program that goes to a robot: the chosen one, else the one that it has, else the one that is open. */
export function programFor(
  { chosen, boards }: Pick<BoardsState, "chosen" | "boards">,
  address: string,
  programs: readonly string[],
  open: string,
): string {
  const wanted = [chosen[address], boards[address]?.program, open];
  return wanted.find((one) => one !== undefined && programs.includes(one)) ?? programs[0] ?? "";
}

/** Whether it was said what the robot there is built of, or the one before it. */
export function knowsKit({ kits }: Pick<BoardsState, "kits">, address: string): boolean {
  return kits[address] !== undefined || kits[""] !== undefined;
}

/** The kit that a robot is built of: what was chosen for it, else what was chosen last for another; "" for none. */
export function kitFor({ kits }: Pick<BoardsState, "kits">, address: string): string {
  return kits[address] ?? kits[""] ?? "";
}

/** Whether this page talks with it, so that it may do more than stop it. */
export function isMine(state: Pick<BoardsState, "you">, board: Board | null): boolean {
  return board === null || board.holder === state.you;
}
