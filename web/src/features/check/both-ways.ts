/** What of two ways is shown side by side: the runs of the simulator from just before they part, or states of the model. */
import type { CheckedProperty, ConfirmingRun, RunStretch, StretchEvent } from "../../api/generated";
import { stretchApi } from "../../api/run-stretch";
import { t } from "../../i18n/words";
import type { Mission } from "../../model/types";
import { withFailures } from "../../session/confirming-run";

/** Both are the same for so long at first, and the one that keeps the property goes on so long behind the break. */
const BEFORE_S = 1;
const AFTER_S = 2;
/** So much before the break where the simulator does not say when it was decided. */
const UNKNOWN_S = 8;
/** A step of the simulator in a run that breaks in its first one. */
const USUAL_TICK_S = 0.02;

/** Steps of the simulator: where both begin, where they part, and where each ends; null: it has no run. */
export interface Span {
  first: number;
  parts: number;
  brokenLast: number;
  keptLast: number | null;
  tickS: number;
}

/** What is shown of the runs of the simulator; null where none breaks the property. */
export function spanOf({ confirmed, why }: Pick<CheckedProperty, "confirmed" | "why">): Span | null {
  if (confirmed === null || why === null) return null;
  const tickS = confirmed.tick > 0 ? confirmed.seconds / confirmed.tick : USUAL_TICK_S;
  const ticks = (seconds: number) => Math.round(seconds / tickS);
  const { kept } = why;
  const known = kept?.tick ?? why.tick;
  const parts = known >= 0 ? Math.min(known, confirmed.tick) : Math.max(0, confirmed.tick - ticks(UNKNOWN_S));
  const brokenLast = Math.max(confirmed.tick, 1);
  return {
    ...{ parts, brokenLast, tickS },
    first: Math.max(0, Math.min(parts, brokenLast - 1) - (known >= 0 ? ticks(BEFORE_S) : 0)),
    keptLast: kept === null ? null : brokenLast + ticks(kept.delay_s + AFTER_S),
  };
}

export interface Recorded {
  broken: RunStretch | null;
  kept: RunStretch | null;
}

/** Both runs, as far as the simulator has them. */
export async function recordWays(
  { mission, path }: { mission: Mission; path: string },
  { confirmed, why }: Pick<CheckedProperty, "confirmed" | "why">,
  span: Span | null,
): Promise<Recorded> {
  const record = (run: ConfirmingRun | null | undefined, last: number | null) =>
    run == null || span === null || last === null
      ? null
      : stretchApi.record({ mission: withFailures(mission, run), path, seed: run.seed, first: span.first, last });
  const [broken, kept] = await Promise.all([
    record(confirmed, span?.brokenLast ?? null),
    record(why?.kept, span?.keptLast ?? null),
  ]);
  return { broken, kept: kept && withoutWait(kept, why?.kept?.delayed ?? "") };
}

/** The frame of a stretch that many seconds after its beginning; the last one behind its end. */
export function frameAt({ run, frame_s: apart }: RunStretch, seconds: number): number {
  return Math.min(Math.max(0, seconds / apart), Math.max(0, run.frames - 1));
}

/** What is said of what happened last since a moment, and at its end why the run ended; "" before anything did. */
export function lastEvent({ run, frame_s: apart, events, ending }: RunStretch, since: number, seconds: number): string {
  if (ending !== "" && seconds >= (run.frames - 1) * apart) return ending;
  const past = events.filter((event) => event.seconds >= since && event.seconds <= seconds);
  const found = past.findLast(({ kind }) => kind !== "message");
  return found === undefined ? "" : t("check.way-event", { agent: found.agent, text: found.text });
}

/** A stretch without that an agent waits in it: that is said of the whole of it. */
function withoutWait(stretch: RunStretch, agent: string): RunStretch {
  const waits = ({ kind, agent: who }: StretchEvent) => who === agent && (kind === "failure" || kind === "revival");
  return { ...stretch, events: stretch.events.filter((event) => !waits(event)) };
}
