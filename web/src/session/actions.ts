/** Actions on the run and on programs, shared by menus, toolbar and keys. */
import { t } from "../i18n/words";
import { type Command, commandTo } from "../model/command";
import { addProgram, emptyProgram, moveProgram, removeProgram } from "../model/commands/changePrograms";
import { freeName } from "../model/free-name";
import { execute, useStudio } from "../model/studio";
import type { Mission, Program, World } from "../model/types";
import { bannerAction, note, useDocument, whenReady } from "./document";
import { isLive, useRun, watchedAgent } from "./run";
import { closeTeam, openTeam } from "./team-view";
import { whenFollowed } from "./typing";
import { useView } from "./view";

export function run(): void {
  // Over the mission lies the page of another one: nothing runs below it.
  const { overlay, ready } = useDocument.getState();
  if (overlay === "new") return;
  if (!ready) {
    void whenReady().then(run);
    return;
  }
  const { status, start, resume } = useRun.getState();
  if (status === "paused") {
    resume();
  } else if (!isLive(status)) {
    whenFollowed(() => {
      const { mission, file } = useStudio.getState();
      if (!isLive(useRun.getState().status)) start({ mission, path: file.path });
    });
  }
}

export function pause(): void {
  const { status, pause: hold, resume } = useRun.getState();
  if (status === "paused") resume();
  else hold();
}

/** To the next vertex of the agent that is watched in the open program, or back to the one before. */
export function stepVertex(back: boolean): void {
  const { activeProgram } = useStudio.getState();
  const state = useRun.getState();
  state.step("vertex", back, watchedAgent(state, activeProgram)?.name ?? "");
}

/** The first start of the world that no agent uses. */
export function freeStart(mission: Mission, world: World | null): string | null {
  const taken = mission.agents.flatMap((agent) => [agent.name, agent.start === "" ? agent.name : agent.start]);
  return world?.starts.find((start) => !taken.includes(start.name))?.name ?? null;
}

/**
 * A new program and, where the world has a place for it, one agent that runs it: what is drawn should also move.
 */
export function programWithAgent(mission: Mission, program: Program, world: World | null): Command | null {
  const inner = addProgram(mission, program);
  const start = freeStart(mission, world);
  if (inner === null || start === null) return inner;
  const agent = { name: start, program: program.name, start: "" };
  const after = inner.execute(mission);
  return commandTo(inner.label, { ...after, agents: [...after.agents, agent] });
}

export function addProgramFor(robot: string): void {
  const names = useStudio.getState().mission.programs.map((program) => program.name);
  addProgramWithAgent(emptyProgram(freeName("program", names), robot));
}

/** Adds a program and shows it; whether it has a robot that runs it. Where the world has no place for one, says who could. */
export function addProgramWithAgent(program: Program): boolean {
  const { mission, world, setActiveProgram, activeProgram } = useStudio.getState();
  const { name } = program;
  const command = programWithAgent(mission, program, world);
  if (!execute(command)) return false;
  setActiveProgram(name);
  if (useStudio.getState().mission.agents.some((agent) => agent.program === name)) return true;
  const fits = mission.programs.some((one) => one.name === activeProgram && one.robot === program.robot);
  const agent = fits ? mission.agents.find((one) => one.program === activeProgram) : undefined;
  note(t("team.no-free-start", { name }), "", [
    ...(agent === undefined
      ? []
      : [bannerAction(t("team.let-run", { agent: agent.name, name }), () => void letRun(agent.name, name))]),
    bannerAction(t("team.open"), openTeam),
  ]);
  return false;
}

/** An agent runs another program from now on. */
async function letRun(agent: string, program: string): Promise<void> {
  const { giveProgram } = await import("../model/commands/changeAgents");
  const { mission } = useStudio.getState();
  const at = mission.agents.findIndex((one) => one.name === agent);
  execute(giveProgram(mission, at, program));
}

export function removeProgramNamed(name: string): void {
  execute(removeProgram(useStudio.getState().mission, name));
}

/** Speeds that the menu and the keys step through; 0 is as fast as it goes. */
export const SPEEDS = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 0] as const;

/** The neighbour of a speed on the scale. */
export function nextSpeed(speed: number, by: 1 | -1): number {
  const rank = (one: number) => (one === 0 ? Infinity : one);
  const ordered = by > 0 ? SPEEDS : [...SPEEDS].reverse();
  return ordered.find((one) => (by > 0 ? rank(one) > rank(speed) : rank(one) < rank(speed))) ?? speed;
}

export function changeSpeed(by: 1 | -1): void {
  const { speed, setSpeed } = useRun.getState();
  setSpeed(nextSpeed(speed, by));
}

/** Opens the program of the neighbouring tab; after the last comes the first. */
export function goToProgram(by: 1 | -1): void {
  const { mission, activeProgram, setActiveProgram } = useStudio.getState();
  const { programs } = mission;
  const at = programs.findIndex((one) => one.name === activeProgram);
  const next = programs[(at + by + programs.length) % programs.length];
  closeTeam();
  if (next !== undefined) setActiveProgram(next.name);
}

/** Moves the open program's tab one place on. */
export function moveActiveProgram(by: 1 | -1): void {
  const { mission, activeProgram } = useStudio.getState();
  execute(moveProgram(mission, activeProgram, by));
}

/** Brings a vertex into view: its program's tab, then the vertex itself. */
export function reveal(program: string, vertices: string[]): void {
  closeTeam();
  const { setActiveProgram, select } = useStudio.getState();
  setActiveProgram(program);
  const [first] = vertices;
  if (first === undefined) return;
  select(vertices);
  // The canvas draws the other program first.
  requestAnimationFrame(() => useView.getState().viewport?.reveal(first));
}
