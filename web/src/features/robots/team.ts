/** The team of the mission that is open, as processes: which agent has which board, sending to all of them, starting it. */
import { useStudio } from "../../model/studio";
import { useRun } from "../../session/run";
import { type BoardsState, forgetRefusal, type Place, placesOf, setBodies, useBoards, without } from "./boards";
import { keepShown } from "./board-run";
import { send } from "./socket";
import type { Board, Team, TeamAgent } from "./wire";

/** So many agents a fleet has at most; `team.charter` of the server has the number. */
export const MOST_AGENTS = 64;
/** What is refused to a team is refused to this address. */
export const TEAM = "team";

const MOST_BODIES = 200;

export function bodyKey(path: string, agent: string): string {
  return `${path}\n${agent}`;
}

/** The address of the board that is an agent's body; "" where it is simulated. */
export function bodyOf({ bodies }: Pick<BoardsState, "bodies">, path: string, agent: string): string {
  return bodies[bodyKey(path, agent)] ?? "";
}

/** Gives an agent a board, or with "" a simulated body. A board is one agent's: whoever had it has it no more. */
export function withBody(bodies: BoardsState["bodies"], path: string, agent: string, address: string) {
  const others = Object.entries(without(bodies, bodyKey(path, agent))).filter(
    ([key, taken]) => taken !== address || !key.startsWith(`${path}\n`),
  );
  if (address !== "") others.push([bodyKey(path, agent), address]);
  return Object.fromEntries(others.slice(-MOST_BODIES));
}

export function chooseBody(agent: string, address: string): void {
  const { path } = useStudio.getState().file;
  setBodies((bodies) => withBody(bodies, path, agent, address));
}

/** The places that can be chosen for an agent: those that are listed, and the chosen one though it is not there. */
export function placesFor(state: BoardsState, chosen: string): Place[] {
  const places = placesOf(state);
  if (chosen === "" || places.some(({ address }) => address === chosen)) return places;
  return [
    ...places,
    { address: chosen, name: chosen.replace(/^\w+:\/\//, ""), description: "", firmware: "", board: null },
  ];
}

/** What the server says of an agent, where its team is that of the mission which is open. */
export function standingOf(team: Team | null, path: string, agent: string): TeamAgent | undefined {
  return team?.path === path ? team.agents.find(({ name }) => name === agent) : undefined;
}

export function isBusy(team: Team | null): boolean {
  return team !== null && team.phase !== "idle";
}

function boardsOf(state: BoardsState, ways: Record<string, Board["way"]> = {}) {
  const { mission, file } = useStudio.getState();
  return mission.agents.flatMap(({ name }) => {
    const address = bodyOf(state, file.path, name);
    return address === "" ? [] : [{ agent: name, address, way: ways[name] ?? ("" as const) }];
  });
}

/** `ways`: what else may be done at the boards of agents that refused before. */
export function sendToAll(ways: Record<string, Board["way"]> = {}): void {
  const { mission, file } = useStudio.getState();
  forgetRefusal(TEAM);
  send({ type: "team-send", mission, path: file.path, boards: boardsOf(useBoards.getState(), ways) });
}

export function cancelTeam(): void {
  send({ type: "team-cancel" });
}

/** Starts the processes of all agents; what they do is shown as a run, in the place of what was on. */
export function startTeam(): void {
  keepShown();
  const { mission, file } = useStudio.getState();
  const state = useBoards.getState();
  forgetRefusal(TEAM);
  const { stop, robots, seed } = useRun.getState();
  stop();
  robots({ type: "fleet", mission, path: file.path, holder: state.you, boards: boardsOf(state), seed });
}
