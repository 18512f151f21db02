/**
 * What has happened up to the moment that the run stands at, in a list: when, who, what, and what brought it about. A
 * moment of it can be gone to.
 *
 * The timeline shows the same as marks, for the eye. Only the last `SHOWN` are here: those before are a drag away.
 */
import { useMemo } from "react";

import type { RunEvent } from "../../api/wire";
import { clock } from "../../i18n/numbers";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { can, useRun } from "../../session/run";

export const SHOWN = 100;

/** The last ones up to a tick, the newest first. */
export function lastOf(events: readonly RunEvent[], tick: number, most: number): RunEvent[] {
  return events
    .filter((event) => event.tick <= tick)
    .slice(-most)
    .reverse();
}

/** What happened without its cause in brackets, which stands beside it. */
export function withoutCause({ text, cause }: RunEvent): string {
  const said = cause === "person" || cause === "mission" || cause === "chance";
  return said ? text.replace(/\s*\([^()]*\)$/, "") : text;
}

export function EventList() {
  const events = useRun((run) => run.events);
  const tick = useRun((run) => run.tick);
  const tickMs = useRun((run) => run.tickMs);
  const goes = useRun((run) => can("seek", run));
  const last = events.at(-1)?.tick ?? 0;
  // While the run is at its newest moment only a new event changes the list.
  const until = tick >= last ? Infinity : tick;
  const shown = useMemo(() => lastOf(events, until, SHOWN), [events, until]);
  if (shown.length === 0) return <p className="watch-happened is-empty">{t("debug.no-events")}</p>;
  return (
    <div className="watch-happened" role="region" aria-label={t("debug.events")} tabIndex={0}>
      <EventTable shown={shown} tickMs={tickMs} goes={goes} />
    </div>
  );
}

function EventTable({ shown, tickMs, goes }: { shown: RunEvent[]; tickMs: number; goes: boolean }) {
  return (
    <table className="watch-table watch-events" data-testid="event-list">
      <caption>{t("debug.events")}</caption>
      <thead className="only-spoken">
        <tr>
          <th scope="col">{t("debug.event-when")}</th>
          <th scope="col">{t("debug.event-who")}</th>
          <th scope="col">{t("debug.event-what")}</th>
          <th scope="col">{t("debug.event-why")}</th>
        </tr>
      </thead>
      <tbody>
        {shown.map((event, index) => {
          const time = clock((event.tick * tickMs) / 1000);
          return (
            <tr key={index} data-kind={event.kind} data-cause={event.cause}>
              <td>
                <button
                  type="button"
                  className="moment"
                  disabled={!goes}
                  title={t("debug.event-go", { time })}
                  onClick={() => useRun.getState().seek(event.tick)}
                >
                  {time}
                </button>
              </td>
              <th scope="row">{event.agent}</th>
              <td>
                {/* What is done by hand has that as its cause beside it. */}
                {event.kind === "outside" ? null : `${t(`strip.${event.kind}`)}: `}
                <Said text={withoutCause(event)} />
              </td>
              <td className="muted">{t(`debug.cause-${event.cause}`)}</td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}
