/**
 * A command: one change of the document that can be taken back.
 *
 * `execute` and `revert` are pure: each takes a mission and gives another one, sharing what did not change. Commands
 * live one a file in `commands/`; the store (studio.ts) keeps the two stacks.
 */
import type { Mission, Program } from "./types";

export interface Command {
  /** What it does, in the words of a menu: "Delete While". */
  label: string;
  execute: (mission: Mission) => Mission;
  revert: (mission: Mission) => Mission;
  /** Vertices to select afterwards; without it the selection stays as far as it still exists. */
  selects?: string[];
  /** Commands with the same key that follow each other closely (a slider, a word) are taken back as one. */
  joins?: string;
}

function withProgram(mission: Mission, name: string, program: Program): Mission {
  return { ...mission, programs: mission.programs.map((one) => (one.name === name ? program : one)) };
}

/** The command that puts `after` in the place of `before`, a program of the mission. */
export function replaceProgram(label: string, before: Program, after: Program, selects?: string[]): Command {
  return {
    label,
    execute: (mission) => withProgram(mission, before.name, after),
    revert: (mission) => withProgram(mission, after.name, before),
    ...(selects === undefined ? {} : { selects }),
  };
}
