/**
 * A command: one change of the document.
 *
 * `execute` is pure: it takes a mission and gives another one, sharing what did not change; the same one when there is
 * nothing to do. Commands live one a file in `commands/`. Nothing is changed in place, so undo needs no command: the history
 * (history.ts) has the missions before and after.
 */
import type { Mission, Program } from "./types";

export interface Command {
  /** What it does, in the words of a menu: "Delete While". */
  label: string;
  execute: (mission: Mission) => Mission;
  /** Vertices to select afterwards; without it the selection stays as far as it still exists. */
  selects?: string[];
  /** Commands with the same key that follow each other closely (a slider, a word) are taken back as one. */
  joins?: string;
  /** When the person did it, in ms since 1970, where an answer of the server came between; without it, now. */
  at_ms?: number;
}

/** The command that leads to `after`. */
export function commandTo(label: string, after: Mission, more: Pick<Command, "selects" | "joins"> = {}): Command {
  return { label, execute: () => after, ...more };
}

/** The mission with these parts, of which it says nothing where they are empty or null; others stay the same objects. */
export function withOptional(mission: Mission, parts: Partial<Mission>): Mission {
  const isEmpty = (value: unknown) => value == null || (Array.isArray(value) && value.length === 0);
  const all = Object.entries({ ...mission, ...parts });
  return Object.fromEntries(all.filter(([name, value]) => !(name in parts && isEmpty(value)))) as unknown as Mission;
}

function withProgram(mission: Mission, name: string, program: Program): Mission {
  return { ...mission, programs: mission.programs.map((one) => (one.name === name ? program : one)) };
}

/** The command that puts `after` in the place of `before`, a program of the mission. */
export function replaceProgram(label: string, before: Program, after: Program, selects?: string[]): Command {
  return {
    label,
    execute: (mission) => withProgram(mission, before.name, after),
    ...(selects === undefined ? {} : { selects }),
  };
}
