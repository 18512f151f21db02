/** Lines of pens, made of their marks, and drawn plainly: round ends, as wide as they are, three px at least. */
import { drawnByPens, type PenMark } from "../../session/pen-marks";
import { toScreen } from "./camera";
import type { Brush } from "./draw-world";
import { strokeWith } from "./ink";

/** What becomes of a point: a line begins there, or ends. */
const [BEGINS, ENDS] = [2, 4];
const LEAST_PX = 3;

/** Colours of pens by number; black is ink, which the theme says. */
export const PEN_COLOURS = [null, "#d3202f", "#1c8548", "#1d6ad4", "#e07a1f", "#7549cc", "#d9a400", "#d9529a"] as const;

export interface PenStroke {
  colour: number;
  width_mm: number;
  points: [x_mm: number, y_mm: number][];
}

/**
 * The lines, in the order in which they began.
 *
 * @param ends where a pen that is still down is now.
 */
export function strokesOf(
  marks: readonly PenMark[],
  ends: (pen: number) => readonly [number, number] | undefined,
): PenStroke[] {
  const strokes: PenStroke[] = [];
  const open = new Map<number, PenStroke>();
  for (const [pen, what, x, y, colour, width_mm] of marks) {
    if (what === BEGINS) {
      const stroke: PenStroke = { colour, width_mm, points: [] };
      strokes.push(stroke);
      open.set(pen, stroke);
    }
    open.get(pen)?.points.push([x / 10, y / 10]);
    if (what === ENDS) open.delete(pen);
  }
  for (const [pen, stroke] of open) {
    const end = ends(pen);
    if (end !== undefined) stroke.points.push([end[0], end[1]]);
  }
  return strokes;
}

/** What the pens of the run drew so far; `poses`: where its agents are, in their order. */
export function strokesOfRun(poses: readonly { x_mm: number; y_mm: number }[]): PenStroke[] {
  const { marks, pens } = drawnByPens();
  return strokesOf(marks, (pen) => {
    const at = poses[pens[pen] ?? -1];
    return at === undefined ? undefined : [at.x_mm, at.y_mm];
  });
}

export function drawStrokes({ pen, camera, colours }: Brush, strokes: readonly PenStroke[]): void {
  pen.save();
  pen.lineCap = "round";
  pen.lineJoin = "round";
  for (const { colour, width_mm, points } of strokes) {
    pen.beginPath();
    for (const [x, y] of points) pen.lineTo(...toScreen(camera, x, y));
    const first = points[0];
    // A dot is a line to where it began.
    if (points.length === 1 && first !== undefined) pen.lineTo(...toScreen(camera, first[0], first[1]));
    strokeWith(pen, PEN_COLOURS[colour] ?? colours.ink, Math.max(width_mm * camera.scale, LEAST_PX));
  }
  pen.restore();
}
