/** Frames and arcs, in two layers: frames under the vertices, arcs over them. */
import { type CSSProperties, memo, useMemo } from "react";

import { t } from "../../i18n/words";
import {
  headPath,
  type LayoutArc,
  type LayoutFrame,
  type LayoutLeap,
  type Point,
  roundedPath,
} from "../../model/layout";
import { reportError } from "../../session/document";
import { justDragged, useDrag } from "../../session/drag";
import { currentDrawing, type Drawing } from "../../session/drawing";
import { spokenArc } from "../../session/spoken";
import { useView } from "../../session/view";
import { later } from "../../ui/later";
import { FoldControls } from "./Folding";
import { useMoved } from "./drag-contents";
import { boxInside, type Part } from "./part";

const Lanes = later(() => import("./Lanes").then((chunk) => chunk.Lanes), reportError);

function arcInside({ points }: Pick<LayoutArc, "points">, { x0, y0, x1, y1 }: Part): boolean {
  let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const { x, y } of points) {
    left = Math.min(left, x);
    right = Math.max(right, x);
    top = Math.min(top, y);
    bottom = Math.max(bottom, y);
  }
  return left < x1 && right > x0 && top < y1 && bottom > y0;
}

/** `plain`: without what could not be read or aimed at from far away. */
export function Lines({ layout, part, plain }: { layout: Drawing["layout"]; part: Part; plain: boolean }) {
  const arcs = useMemo(() => layout.arcs.filter((arc) => arcInside(arc, part)), [layout, part]);
  const frames = useMemo(() => layout.frames.filter((frame) => boxInside(frame, part)), [layout, part]);
  const leaps = useMemo(() => layout.leaps.filter((leap) => arcInside(leap, part)), [layout, part]);
  const seen = new Set<string>();
  return (
    <>
      {plain ? null : <FoldControls frames={frames} />}
      <svg className="frames" width="1" height="1" aria-hidden="true">
        {frames.map((frame) => (
          <Frame key={`${frame.kind} ${frame.id}`} frame={frame} />
        ))}
      </svg>
      {layout.lanes.length > 0 ? <Lanes lanes={layout.lanes} /> : null}
      <svg className="arcs" width="1" height="1">
        <Leaps leaps={leaps} />
        {arcs.map((arc) => {
          // An arc that is drawn in two strokes (around the place of a new program) is one arc to hands and tests.
          const again = seen.has(arc.id);
          seen.add(arc.id);
          return <Arc key={again ? `${arc.id} 2` : arc.id} arc={arc} again={again} plain={plain} />;
        })}
      </svg>
    </>
  );
}

const Frame = memo(function Frame({ frame: { id, kind, colour, x, y, w, h } }: { frame: LayoutFrame }) {
  const aimed = useDrag((state) => state.target?.key === `vertex:${id}`);
  const flat = kind === "parallel";
  return (
    <>
      <rect
        className={`frame frame-${kind}${aimed ? " is-aimed" : ""}`}
        data-colour={colour}
        data-frame={id}
        rx={flat ? 0 : 8}
        style={{ x, y, width: w, height: h }}
      />
      {kind === "parked" ? (
        <text className="frame-title" x={x + 16} y={y + 24}>
          {t("graph.parked")}
        </text>
      ) : null}
    </>
  );
});

/** Where the dot of an arc stands: in the middle of its first stretch, or of its last one where it leaves sideways. */
function spotOf({ points }: LayoutArc): Point {
  const [a, b] = points;
  const [y, z] = points.slice(-2);
  const between = (from: Point | undefined, to: Point | undefined): Point => ({
    x: ((from?.x ?? 0) + (to?.x ?? 0)) / 2,
    y: ((from?.y ?? 0) + (to?.y ?? 0)) / 2,
  });
  return a?.x === b?.x ? between(a, b) : between(y, z);
}

export function spotOfArc(id: string): Point | null {
  const arc = currentDrawing()?.layout.arcs.find((one) => one.id === id);
  return arc === undefined ? null : spotOf(arc);
}

const Arc = memo(function Arc({ arc, again, plain }: { arc: LayoutArc; again: boolean; plain: boolean }) {
  const { id, points, colour, head, label, missing, dead } = arc;
  const selected = useView((state) => state.arc === id);
  const aimed = useDrag((state) => state.target?.key === `arc:${id}`);
  const own = useMoved(arc.source);
  const path = roundedPath(points, head);
  const tip = head && !plain ? headPath(points) : "";
  const spot = spotOf(arc);
  const classes = ["arc"];
  if (selected) classes.push("is-selected");
  if (aimed) classes.push("is-aimed");
  if (own) classes.push("is-own");
  if (missing) classes.push("is-missing");
  if (dead) classes.push("is-dead");
  const select = () => {
    if (justDragged()) return;
    useView.getState().selectArc(id);
    useView.getState().viewport?.focus();
  };
  return (
    <g className={classes.join(" ")} data-colour={colour} data-arc={id} onClick={select}>
      <path className="arc-reach" d={path} />
      <path className="arc-line" d={path} style={plain ? undefined : moving(path)} />
      {tip !== "" ? <path className="arc-head" d={tip} style={moving(tip)} /> : null}
      {label === null || plain ? null : (
        <text
          className="arc-label"
          style={{ transform: shift(label) }}
          textAnchor={label.anchor}
          dominantBaseline="central"
        >
          {label.text}
        </text>
      )}
      {again || plain ? null : (
        <g
          className="arc-spot"
          data-testid={`arc-${id}`}
          role="button"
          aria-label={spokenArc(arc)}
          aria-pressed={selected}
          style={{ transform: shift(spot) }}
        >
          {aimed ? <rect className="arc-gap" x="-72" y="-15" width="144" height="30" rx="6" /> : null}
          <circle r="9" />
          <path d="M-4 0H4M0 -4V4" />
        </g>
      )}
    </g>
  );
});

/** As a style, so that a path that changes moves there (where the browser can; the attribute holds everywhere). */
function moving(path: string): CSSProperties {
  return { d: `path("${path}")` };
}

function shift({ x, y }: Point): string {
  return `translate(${String(x)}px, ${String(y)}px)`;
}

/** Where a Break leads: lines on lanes of their own. They are to be seen, not to be dropped on (model/layout/break-edges.ts). */
const Leaps = memo(function Leaps({ leaps }: { leaps: readonly LayoutLeap[] }) {
  return leaps.map(({ source, points, colour, label }) => {
    const path = roundedPath(points, true);
    const head = headPath(points);
    return (
      <g key={source} className="arc leap passive" data-colour={colour} data-testid={`leap-${source}`}>
        <path className="arc-line" d={path} style={{ d: `path("${path}")` }} />
        <path className="arc-head" d={head} style={{ d: `path("${head}")` }} />
        <text
          className="arc-label"
          style={{ transform: `translate(${String(label.x)}px, ${String(label.y)}px)` }}
          textAnchor={label.anchor}
          dominantBaseline="central"
        >
          {label.text}
        </text>
      </g>
    );
  });
});
