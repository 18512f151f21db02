/**
 * Real robots as the run that the page shows: the same seam as a simulated run, so vertices glow, tabs, code, watch and STOP
 * work as they do there.
 *
 * A robot is shown while it has a program of the mission that is open, from the moment it runs. Only those that this page
 * holds: it knows what they were given. There is one clock on the page; it is that of the robot that ran longest.
 */
import type { RunRequest } from "../../api/wire";
import { useStudio } from "../../model/studio";
import { isLive, type RunAgent, type RunState, showReal, useRun } from "../../session/run";
import { t } from "../../i18n/words";
import { type BoardsState, isMine, useBoards } from "./boards";
import { send } from "./socket";
import { useRobotsPanel } from "./state";
import type { Board } from "./wire";

const ACTIVITY: Record<Board["state"], RunAgent["state"]> = {
  none: "idle",
  ready: "idle",
  running: "running",
  ended: "idle",
  fault: "failed",
};

/** Names of robots on the page: those of the list, told apart where two are called alike. */
export function namesOf(boards: readonly Board[]): string[] {
  return boards.map((board, at) => {
    const alike = boards.filter(({ name }) => name === board.name);
    return alike.length < 2 ? board.name : `${board.name} ${String(alike.indexOf(boards[at] ?? board) + 1)}`;
  });
}

/** The robots that the canvas can show. */
export function shownBoards(state: BoardsState, path: string): Board[] {
  return Object.values(state.boards).filter(
    (board) => isMine(state, board) && board.program !== "" && state.given[board.address]?.path === path,
  );
}

function agentOf(board: Board, name: string, number: number): RunAgent {
  const lost = board.phase === "lost";
  return {
    name,
    program: board.program,
    robot: board.robot,
    number,
    kind: "",
    placed: false,
    active: lost ? [] : board.active,
    state: lost ? "stalled" : ACTIVITY[board.state],
    values: board.values,
    inputs: board.inputs,
    fault: board.fault?.number ?? 0,
    forced: board.forced,
    shown: {},
  };
}

function isRunning(board: Board): boolean {
  return board.phase === "open" && board.state === "running";
}

/** What the run is as a whole. */
function statusOf(boards: readonly Board[]): Pick<RunState, "status" | "sentence"> {
  if (boards.some(isRunning)) return { status: "running", sentence: "" };
  const wrong = boards.find(({ phase, state }) => phase === "lost" || state === "fault");
  if (wrong !== undefined) {
    return { status: "failed", sentence: wrong.phase === "lost" ? wrong.message : (wrong.fault?.sentence ?? "") };
  }
  const ended = boards.find(({ state }) => state === "ended");
  if (ended === undefined) return { status: "stopped", sentence: "" };
  return { status: "done", sentence: t("boards.ended-on", { name: ended.name }) };
}

/** The run that these robots are. */
export function runOf(boards: readonly Board[], before: RunAgent[]): Partial<RunState> {
  const names = namesOf(boards);
  const agents = boards.map((board, at) => {
    const agent = agentOf(board, names[at] ?? board.name, at + 1);
    const was = before.find(({ name }) => name === agent.name)?.active ?? [];
    const same = JSON.stringify(was) === JSON.stringify(agent.active);
    return same ? { ...agent, active: was } : agent;
  });
  const clock = boards.reduce<Board | null>((most, one) => (most === null || one.tick > most.tick ? one : most), null);
  return {
    ...statusOf(boards),
    agents,
    tick: clock?.tick ?? 0,
    latest: clock?.tick ?? 0,
    seconds: clock?.seconds ?? 0,
  };
}

/** What is asked of the run is asked of the robot of that name. */
function obey(request: RunRequest): void {
  if (request.type === "stop") {
    send({ type: "stop", address: "" });
    return;
  }
  if (request.type !== "force" && request.type !== "set") return;
  const boards = shownBoards(useBoards.getState(), useStudio.getState().file.path);
  const at = namesOf(boards).indexOf(request.agent);
  const address = boards[at]?.address;
  if (address === undefined) return;
  if (request.type === "force") send({ type: "force", address, sensor: request.sensor, value: request.value });
  else send({ type: "set", address, variable: request.variable, value: request.value });
}

let kept = false;

/** From now on the page shows robots that run; once is enough. */
export function keepShown(): void {
  if (kept) return;
  kept = true;
  useBoards.subscribe((state, before) => {
    if (state.boards === before.boards) return;
    useRobotsPanel.setState({ running: Object.values(state.boards).filter(isRunning).length });
    const { file } = useStudio.getState();
    const boards = shownBoards(state, file.path);
    const run = useRun.getState();
    if (!run.real && (isLive(run.status) || !boards.some(isRunning))) return;
    if (boards.length === 0 && run.agents.length === 0) return;
    const mission = state.given[boards[0]?.address ?? ""]?.mission ?? null;
    showReal({ send: obey, close: () => undefined }, { ...runOf(boards, run.real ? run.agents : []), mission });
  });
}
