/**
 * The timeline: what has happened so far, ▲ load ▼ unload ○ message ✕ collision ⊗ failure ⊕ revival ↷ a role or
 * group changed hands ■ end, what
 * is to go wrong on schedule (dashed), and a handle to go back to any moment
 * and on again.
 *
 * A slider like any other for keys and screen readers. The axis is one minute long and doubles when the run outgrows it.
 */
import { type KeyboardEvent, type PointerEvent, useLayoutEffect, useMemo, useRef, useState } from "react";

import type { RunEvent, RunEventKind } from "../../api/wire";
import { axisTime, clock, grouped } from "../../i18n/numbers";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import type { ScheduledFailure } from "../../model/types";
import { can, targetTick, useRun } from "../../session/run";
import { useShown } from "../../session/simple-view";

const FIRST_S = 60;
const LANE = 11;
const GAP_PX = 9;
const NOTHING_PLANNED: readonly ScheduledFailure[] = [];
/** Where the axis begins, from the left of the strip. */
const EDGE = 18;

/** How much of the axis may be used before it doubles, at most: the label of the moment needs room at its right. */
const FULL = 0.86;
/** The room that the label takes beyond the end of the axis, in px. */
const LABEL_PX = 104;

/** The room that the time of a mark takes, in px. */
const TIME_PX = 40;

/** Which of the seven marks tell their time, so that no two touch: every one, every second, … or the first and the last. */
export function toldMarks(room: number): number {
  return [1, 2, 3].find((every) => (every * room) / 6 >= TIME_PX) ?? 6;
}

/** How many seconds an axis of `room` px holds, and the distance of its marks. */
export function axisFor(seconds: number, room: number): { length: number; step: number } {
  const full = Math.min(FULL, Math.max(1 - LABEL_PX / room, 0.5));
  let length = FIRST_S;
  while (length * full < seconds) length *= 2;
  return { length, step: length / 6 };
}

const GRAVITY: Record<RunEventKind, number> = {
  end: 0,
  failure: 1,
  revival: 1,
  member: 1,
  outside: 2,
  collision: 3,
  load: 4,
  unload: 4,
  message: 5,
};

/** Those that can be told apart at `gap` px: where they crowd, the weightier stay. In the order of time. */
export function thinned(events: readonly RunEvent[], pxOf: (event: RunEvent) => number, gap: number): RunEvent[] {
  const taken = new Map<number, number>();
  const kept: RunEvent[] = [];
  for (const event of [...events].sort((a, b) => GRAVITY[a.kind] - GRAVITY[b.kind])) {
    const px = pxOf(event);
    const cell = Math.floor(px / gap);
    const crowded = [cell - 1, cell, cell + 1].some((near) => Math.abs((taken.get(near) ?? -Infinity) - px) < gap);
    if (crowded) continue;
    taken.set(cell, px);
    kept.push(event);
  }
  return kept.sort((a, b) => a.tick - b.tick);
}

function Mark({ kind, x, title }: { kind: RunEventKind; x: number; title: string }) {
  const shape = {
    load: <path d="M-4 3.5L0-3.5 4 3.5z" fill="currentColor" />,
    unload: <path d="M-4-3.5L0 3.5 4-3.5z" fill="currentColor" />,
    message: <circle r="3" fill="none" stroke="currentColor" strokeWidth="1.8" />,
    collision: <path d="M-3-3l6 6M3-3l-6 6" stroke="currentColor" strokeWidth="1.8" />,
    failure: <path d="M-2.4-2.4l4.8 4.8M2.4-2.4l-4.8 4.8" stroke="currentColor" strokeWidth="1.6" />,
    revival: <path d="M0-3.2v6.4M-3.2 0h6.4" stroke="currentColor" strokeWidth="1.6" />,
    member: <path d="M-4.5 3C-4.5-4 4-4 4 2M1.5-.5L4 2.5 6-1" fill="none" stroke="currentColor" strokeWidth="1.6" />,
    end: <rect x="-3.5" y="-3.5" width="7" height="7" fill="currentColor" />,
    outside: <path d="M0-4.5L4.5 0 0 4.5-4.5 0z" fill="none" stroke="currentColor" strokeWidth="1.6" />,
  }[kind];
  return (
    <g transform={`translate(${x.toFixed(1)} ${String(LANE)})`} data-kind={kind}>
      <title>{title}</title>
      {kind === "failure" || kind === "revival" ? (
        <circle r="5" fill="none" stroke="currentColor" strokeWidth="1.5" />
      ) : null}
      {shape}
    </g>
  );
}

/** A scheduled failure that is still to come. */
function Planned({ x, title, kind }: { x: number; title: string; kind: string }) {
  return (
    <g transform={`translate(${x.toFixed(1)} ${String(LANE)})`} data-kind="planned" data-testid={`planned-${kind}`}>
      <title>{title}</title>
      <circle r="5" fill="none" stroke="currentColor" strokeWidth="1.5" strokeDasharray="2.6 2.6" />
      <path
        d={kind === "revive" ? "M0-2.6v5.2M-2.6 0h5.2" : "M-2-2l4 4M2-2l-4 4"}
        stroke="currentColor"
        strokeWidth="1.4"
      />
    </g>
  );
}

/** Where a key leads on the timeline, or null. */
export function keyTarget(key: string, tick: number, latest: number, second: number): number | null {
  const steps: Record<string, number> = {
    ArrowLeft: tick - 1,
    ArrowDown: tick - 1,
    ArrowRight: tick + 1,
    ArrowUp: tick + 1,
    PageDown: tick - second,
    PageUp: tick + second,
    Home: 0,
    End: latest,
  };
  const wanted = steps[key];
  return wanted === undefined ? null : Math.min(Math.max(wanted, 0), latest);
}

export function EventStrip() {
  const run = useRun();
  const { events, seconds, tick, latest, tickMs, status, seek } = run;
  const box = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(800);
  useLayoutEffect(() => {
    const element = box.current;
    if (element === null) return;
    const watcher = new ResizeObserver(([entry]) => {
      if (entry !== undefined) setWidth(Math.max(entry.contentRect.width, 120));
    });
    watcher.observe(element);
    return () => watcher.disconnect();
  }, []);

  const room = width - 56;
  const { length, step } = axisFor((latest * tickMs) / 1000, room);
  const shown = useMemo(() => {
    const place = (event: RunEvent) => (((event.tick * tickMs) / 1000) * room) / length;
    return thinned(events, place, GAP_PX).map((event) => ({ event, x: place(event) }));
  }, [events, tickMs, room, length]);
  const schedule = useStudio((studio) => studio.mission.failures);
  const done = (latest * tickMs) / 1000;
  const planned = (schedule ?? NOTHING_PLANNED).filter(({ at_s }) => at_s <= length && (latest === 0 || at_s >= done));
  const now = (seconds * room) / length;
  const known = (((latest * tickMs) / 1000) * room) / length;
  const past = can("seek", run);
  const goTo = (event: PointerEvent) => {
    const left = box.current?.querySelector("svg")?.getBoundingClientRect().left ?? 0;
    seek(Math.min(Math.max(((event.clientX - left - EDGE) * length * 1000) / (room * tickMs), 0), latest));
  };
  const onPointerDown = (event: PointerEvent<HTMLDivElement>) => {
    if (event.button !== 0 || !past) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    goTo(event);
  };
  const onPointerMove = (event: PointerEvent<HTMLDivElement>) => {
    if (past && event.currentTarget.hasPointerCapture(event.pointerId)) goTo(event);
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const target = past ? keyTarget(event.key, targetTick(run), latest, Math.round(1000 / tickMs)) : null;
    if (target === null) return;
    event.preventDefault();
    seek(target);
  };
  const marks = Array.from({ length: 7 }, (_, index) => index * step);
  const told = toldMarks(room);
  const counts = (kind: RunEventKind) => events.filter((event) => event.kind === kind).length;
  const idle = status === "idle" || status === "connecting";
  const ticks = useShown("ticks");
  const label = ticks ? t("strip.now", { time: clock(seconds), tick: grouped(tick) }) : clock(seconds);
  return (
    <div
      className="strip grow focus-inside"
      ref={box}
      dir="ltr"
      data-testid="event-strip"
      role="slider"
      tabIndex={past ? 0 : -1}
      aria-label={t("strip.label")}
      aria-disabled={!past}
      aria-valuemin={0}
      aria-valuemax={latest}
      aria-valuenow={tick}
      aria-valuetext={label}
      onPointerDown={onPointerDown}
      onPointerMove={onPointerMove}
      onKeyDown={onKeyDown}
    >
      <svg width={width} height={44} aria-hidden="true">
        <g transform={`translate(${String(EDGE)} 0)`}>
          <rect className="strip-track" x={-3} y={20} width={room + 6} height={6} rx={3} />
          {idle ? null : <rect className="strip-known" x={-3} y={20} width={known + 3} height={6} rx={3} />}
          {idle ? null : <rect className="strip-past" x={-3} y={20} width={now + 3} height={6} rx={3} />}
          {marks.map((mark, index) => (
            <g key={mark} transform={`translate(${String((mark * room) / length)} 0)`}>
              <path className="strip-tick" d="M0 29v3" />
              {index % told === 0 ? (
                <text className="strip-time" y={42} textAnchor="middle">
                  {axisTime(mark)}
                </text>
              ) : null}
            </g>
          ))}
          <g className="strip-events">
            {planned.map(({ agent, at_s, kind }, index) => (
              <Planned
                key={index}
                kind={kind}
                x={(at_s * room) / length}
                title={t("strip.planned", { time: clock(at_s), agent, kind: t(`team.${kind}`) })}
              />
            ))}
            {shown.map(({ event, x }, index) => (
              <Mark
                key={index}
                kind={event.kind}
                x={x}
                title={t("strip.event", {
                  time: clock((event.tick * tickMs) / 1000),
                  kind: t(`strip.${event.kind}`),
                  agent: event.agent,
                  text: event.text,
                })}
              />
            ))}
          </g>
          {idle ? null : (
            <>
              <path className="strip-now" d={`M${now.toFixed(1)} 3v28`} />
              {past ? <circle className="strip-handle" cx={now} cy={23} r={6} data-testid="strip-handle" /> : null}
              <text className="strip-now-label" x={now + 8} y={12}>
                {label}
              </text>
            </>
          )}
        </g>
      </svg>
      <span className="only-spoken">
        {t("strip.failures", { count: counts("failure") })}{" "}
        {t("strip.counts", { load: counts("load"), unload: counts("unload"), collision: counts("collision") })}
      </span>
    </div>
  );
}
