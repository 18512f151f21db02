/** What a run that did not end well came from: the last thing before its end that went wrong. */
import type { RunEvent } from "../../../api/wire";
import type { RunState } from "../../../session/run";

const WRONG: readonly RunEvent["kind"][] = ["failure", "collision"];

export interface Cause {
  tick: number;
  agent: string;
  text: string;
}

/**
 * The last failure or collision; else the last that anybody did before the end. Null where nothing happened: then nothing
 * is known but the end itself.
 */
export function causeOf({ events, tick }: Pick<RunState, "events" | "tick">): Cause | null {
  const before = events.filter((event) => event.tick <= tick && event.kind !== "end");
  return before.findLast(({ kind }) => WRONG.includes(kind)) ?? before.at(-1) ?? null;
}
