/** Breakpoints of a mission. An empty list is left out; everything else stays the same objects. */
import { t } from "../../i18n/words";
import { type Command, commandTo, withOptional } from "../command";
import { type Parts, title } from "../parts";
import type { Breakpoint, Mission, Program } from "../types";

/** The breakpoint of a vertex, or undefined. */
export function breakpointAt(mission: Mission, program: string, vertex: string): Breakpoint | undefined {
  return mission.breakpoints?.find((one) => one.program === program && one.vertex === vertex);
}

/** Breakpoints whose vertex is there. Those of vertices that are gone go with the next change. */
function sound(mission: Mission): Breakpoint[] {
  return (mission.breakpoints ?? []).filter(({ program, vertex }) =>
    mission.programs.some((one) => one.name === program && one.vertices.some(({ id }) => id === vertex)),
  );
}

/** Sets the breakpoint of a vertex, or changes it; null when there is no such vertex. */
export function setBreakpoint(parts: Parts, mission: Mission, made: Breakpoint): Command | null {
  const there = mission.programs
    .find((one) => one.name === made.program)
    ?.vertices.find(({ id }) => id === made.vertex);
  if (there === undefined) return null;
  const old = breakpointAt(mission, made.program, made.vertex);
  const others = sound(mission);
  const list = old === undefined ? [...others, made] : others.map((one) => (one === old ? made : one));
  return commandTo(
    t("command.breakpoint", { name: title(parts.shape(there.element)) }),
    withOptional(mission, { breakpoints: list }),
  );
}

/** Without the breakpoint of a vertex; null when it has none. */
export function removeBreakpoint(mission: Mission, program: string, vertex: string): Command | null {
  const old = breakpointAt(mission, program, vertex);
  if (old === undefined) return null;
  const list = sound(mission).filter((one) => one !== old);
  return commandTo(t("command.no-breakpoint"), withOptional(mission, { breakpoints: list }));
}

/** The breakpoints after a program was given another name. */
export function breakpointsRenamed(mission: Mission, from: Program["name"], to: string): Pick<Mission, "breakpoints"> {
  if (mission.breakpoints === undefined) return {};
  return {
    breakpoints: mission.breakpoints.map((one) => (one.program === from ? { ...one, program: to } : one)),
  };
}
