/**
 * What the shell can do, each as one function, shared by menus, toolbar and keys.
 */
import { addProgram, deleteProgram } from "../model/commands/programs";
import { useStudio } from "../model/studio";
import { isLive, useRun } from "../run/run";

export function run(): void {
  const { status, start, resume } = useRun.getState();
  if (status === "paused") {
    resume();
  } else if (!isLive(status)) {
    const { mission, file } = useStudio.getState();
    start({ mission, path: file.path });
  }
}

export function pause(): void {
  const { status, pause: hold, resume } = useRun.getState();
  if (status === "paused") resume();
  else hold();
}

export function addProgramFor(robot: string): void {
  const { mission, execute, setActiveProgram } = useStudio.getState();
  const { command, name } = addProgram(mission, robot);
  execute(command);
  setActiveProgram(name);
}

export function removeProgram(name: string): void {
  const { mission, execute } = useStudio.getState();
  const command = deleteProgram(mission, name);
  if (command !== null) execute(command);
}

/** Speeds that the menu and the keys step through; 0 is as fast as it goes. */
export const SPEEDS = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 0] as const;

/** The neighbour of a speed on the scale. */
export function nextSpeed(speed: number, by: 1 | -1): number {
  const rank = (one: number) => (one === 0 ? Infinity : one);
  const ordered = by > 0 ? SPEEDS : [...SPEEDS].reverse();
  return ordered.find((one) => (by > 0 ? rank(one) > rank(speed) : rank(one) < rank(speed))) ?? speed;
}

/** Brings a vertex into view: its program's tab, then the vertex itself. */
export function reveal(program: string, vertices: string[]): void {
  const { setActiveProgram, select } = useStudio.getState();
  setActiveProgram(program);
  if (vertices.length > 0) select(vertices);
}
