/** Whether there is a run of another window to watch; the bar that says so is fetched when there is one. */
import { useDisk } from "../../session/disk";
import { complain } from "../../session/document";
import { isLive, isOurs, useRun } from "../../session/run";
import { later } from "../../ui/later";

const Bar = later(() => import("./WatchingBar").then((chunk) => chunk.WatchingBar), complain);

/** The run that is watched, or can be; "" for none. Who has a run of their own going on is not offered another. */
function useWatchable(): string {
  const watched = useRun((run) => (run.watching ? run.name : ""));
  const busy = useRun((run) => isLive(run.status));
  const offered = useDisk(({ runs }) => runs.find((name) => !isOurs(name)) ?? "");
  return watched !== "" || busy ? watched : offered;
}

export function Watching() {
  const run = useWatchable();
  return run === "" ? null : <Bar run={run} />;
}
