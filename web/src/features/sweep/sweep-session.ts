/**
 * The sweep of this page: asked of the server over a socket of its own, and what came of it.
 *
 * The map keeps the mission, seed and limit that it is of, so that a field that is played is the run that it says, whatever
 * was edited since. It goes when another mission is opened; closing the panel keeps it, and lets a sweep go on.
 */
import { create } from "zustand";

import type { SweepMapMessage, SweepProgressMessage, SweepStartRequest, WorkRefusedMessage } from "../../api/generated";
import type { WhyRefused } from "../../api/refusal";
import { beginWork, type Work } from "../../api/work";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import type { Mission } from "../../model/types";
import { isHeldByRobotsOrFleet } from "../../session/confirming-run";
import { useRun } from "../../session/run";
import type { Place } from "./map";

type Message = SweepProgressMessage | SweepMapMessage | WorkRefusedMessage;
/** What runs of a sweep are of. */
type Asked = Omit<SweepStartRequest, "type" | "moments">;
export interface Swept {
  asked: Asked;
  map: SweepMapMessage;
}

interface SweepState {
  /** How far the sweep is that is on; null while none is. */
  busy: { done: number; total: number } | null;
  swept: Swept | null;
  /** Why there is no map. */
  refused: WhyRefused | null;
  /** The field that was played last. */
  played: Place | null;
}

const NOTHING: SweepState = { busy: null, swept: null, refused: null, played: null };

export const useSweep = create<SweepState>(() => NOTHING);

let work: Work | null = null;

function hangUp(): void {
  work?.hangUp();
  work = null;
}

/** Runs the open mission with each robot failing at so many moments; each run takes so many simulated seconds at most. */
export function begin(moments: number, seconds: number): void {
  hangUp();
  const { mission, file } = useStudio.getState();
  const { seed, failRate } = useRun.getState();
  const asked: Asked = { mission, path: file.path, seed, fail_rate: failRate, seconds };
  useSweep.setState({ ...NOTHING, busy: { done: 0, total: 0 } });
  work = beginWork<Message>(
    "api/sweep",
    { moments, ...asked },
    {
      onMessage: (message) => {
        if (message.type === "progress") {
          useSweep.setState({ busy: { done: message.done, total: message.total } });
          return false;
        }
        useSweep.setState(
          message.type === "map" ? { ...NOTHING, swept: { asked, map: message } } : { ...NOTHING, refused: message },
        );
        return true;
      },
      onLost: () => useSweep.setState({ ...NOTHING, refused: { message: t("sweep.lost"), help: "", problems: [] } }),
    },
  );
}

/** Ends the sweep; the server tells what was found until then. */
export function breakOff(): void {
  if (work?.breakOff() === true) return;
  hangUp();
  useSweep.setState(NOTHING);
}

/** The mission with one more failure on its schedule. */
export function withFailure(mission: Mission, agent: string, at_s: number): Mission {
  const failures = [...(mission.failures ?? []), { agent, at_s, kind: "fail" as const }];
  return { ...mission, failures: failures.sort((a, b) => a.at_s - b.at_s) };
}

/** Plays a field: the run that it stands for, in the place of what was on. */
export function play(place: Place): void {
  const { swept } = useSweep.getState();
  const agent = swept?.map.agents[place.agent];
  const at_s = swept?.map.moments[place.moment];
  if (swept === null || agent === undefined || at_s === undefined || isHeldByRobotsOrFleet()) return;
  const { mission, path, ...like } = swept.asked;
  useSweep.setState({ played: place });
  useRun.getState().start({ mission, path }, { ...like, mission: withFailure(mission, agent, at_s) });
}

useStudio.subscribe((studio, before) => {
  if (studio.change === before.change || studio.change.kind !== "open") return;
  hangUp();
  useSweep.setState(NOTHING);
});
