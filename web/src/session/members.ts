/** What changes who is in a team; the name of the list of members below the graph. */
import type { RunEvent } from "../api/wire";

export const MEMBERS = "members-panel";

/** What changes who is in a team, or is why. */
export function changesOf(events: readonly RunEvent[]): RunEvent[] {
  return events.filter(({ kind }) => kind === "member" || kind === "failure" || kind === "revival");
}
