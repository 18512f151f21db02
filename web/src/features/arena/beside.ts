/** Room for what runs: the arena beside the program, on a small window the room of the arena, from the first moment of each run. */
import { openRoom } from "../../session/narrow";
import { useRun } from "../../session/run";
import { setBeside } from "../../session/stage";

export function keepBeside(): () => void {
  return useRun.subscribe((now, before) => {
    if (now.name === before.name) return;
    // Of real robots nobody knows where they are; before the first message there is no run yet, nor has the last one gone.
    if (now.name !== "" && !now.real && now.agents.some(({ placed }) => placed)) {
      setBeside(true);
      openRoom("arena");
    } else if (now.real || now.status === "idle") setBeside(false);
  });
}
