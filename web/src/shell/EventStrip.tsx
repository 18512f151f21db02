/**
 * The strip of what has happened so far: a time axis with ▲ load ▼ unload ○ message ✕ collision ■ end.
 *
 * It only shows; nothing on it can be dragged. The axis is one minute long and doubles when the run outgrows it.
 */
import { useLayoutEffect, useMemo, useRef, useState } from "react";

import type { RunEvent, RunEventKind } from "../api/wire";
import { useRun } from "../run/run";
import { t } from "../words/words";
import { axisTime, clock, grouped } from "../words/numbers";

const FIRST_S = 60;
const LANE = 11;
const GAP_PX = 9;

/** How much of the axis may be used before it doubles: the label of the moment needs room at its right. */
const FULL = 0.86;

/** How many seconds the axis holds, and the distance of its marks. */
export function axisFor(seconds: number): { length: number; step: number } {
  let length = FIRST_S;
  while (length * FULL < seconds) length *= 2;
  return { length, step: length / 6 };
}

const GRAVITY: Record<RunEventKind, number> = { end: 0, collision: 1, load: 2, unload: 2, message: 3 };

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
    end: <rect x="-3.5" y="-3.5" width="7" height="7" fill="currentColor" />,
  }[kind];
  return (
    <g transform={`translate(${x.toFixed(1)} ${String(LANE)})`} data-kind={kind}>
      <title>{title}</title>
      {shape}
    </g>
  );
}

export function EventStrip() {
  const { events, seconds, tick, tickMs, status } = useRun();
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

  const { length, step } = axisFor(seconds);
  const room = width - 56;
  const shown = useMemo(() => {
    const place = (event: RunEvent) => (((event.tick * tickMs) / 1000) * room) / length;
    return thinned(events, place, GAP_PX).map((event) => ({ event, x: place(event) }));
  }, [events, tickMs, room, length]);
  const now = (seconds * room) / length;
  const marks = Array.from({ length: 7 }, (_, index) => index * step);
  const counts = (kind: RunEventKind) => events.filter((event) => event.kind === kind).length;
  const idle = status === "idle" || status === "connecting";
  const label = t("strip.now", { time: clock(seconds), tick: grouped(tick) });
  return (
    <div className="strip" ref={box} data-testid="event-strip">
      <svg width={width} height={44} role="img" aria-label={t("strip.label")}>
        <g transform="translate(18 0)">
          <rect className="strip-track" x={-3} y={20} width={room + 6} height={6} rx={3} />
          {idle ? null : <rect className="strip-past" x={-3} y={20} width={now + 3} height={6} rx={3} />}
          {marks.map((mark) => (
            <g key={mark} transform={`translate(${String((mark * room) / length)} 0)`}>
              <path className="strip-tick" d="M0 29v3" />
              <text className="strip-time" y={42} textAnchor="middle">
                {axisTime(mark)}
              </text>
            </g>
          ))}
          <g className="strip-events">
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
              <text className="strip-now-label" x={now + 8} y={12}>
                {label}
              </text>
            </>
          )}
        </g>
      </svg>
      <span className="only-spoken">
        {t("strip.counts", { load: counts("load"), unload: counts("unload"), collision: counts("collision") })}
      </span>
    </div>
  );
}
