/**
 * Draws very many robots simply: an arrowhead each, in a few strokes of the pen for all of them together. What tells them
 * apart from far away stays: direction, load, and the signs of those that failed, stalled or lost their radio.
 */
import { toScreen } from "./camera";
import type { Brush } from "./draw-world";
import { ROBOT_MM } from "./geometry";
import { fillWith, strokeWith } from "./ink";
import type { Seen } from "./scene";

const LEAST_PX = 3.5;

interface Dot {
  x: number;
  y: number;
  one: Seen;
}

function arrows({ pen }: Brush, dots: readonly Dot[], size: number): void {
  pen.beginPath();
  for (const { x, y, one } of dots) {
    const ux = Math.cos(one.pose.heading_rad) * size;
    const uy = -Math.sin(one.pose.heading_rad) * size;
    pen.moveTo(x + ux, y + uy);
    pen.lineTo(x - ux * 0.8 - uy * 0.7, y - uy * 0.8 + ux * 0.7);
    pen.lineTo(x - ux * 0.8 + uy * 0.7, y - uy * 0.8 - ux * 0.7);
    // closePath() goes through all that was drawn before, each time.
    pen.lineTo(x + ux, y + uy);
  }
}

/** Strokes for each, light under dark, so that they are seen on everything. */
function signs({ pen, colours }: Brush, dots: readonly Dot[], stroke: (x: number, y: number) => void): void {
  if (dots.length === 0) return;
  pen.beginPath();
  for (const { x, y } of dots) stroke(x, y);
  strokeWith(pen, colours.panel, 4);
  strokeWith(pen, colours.ink, 2);
}

/** The robots on the screen. `program`: those of another one step back; "" for none. */
export function drawCrowd(brush: Brush, seen: readonly Seen[], program: string): void {
  const { pen, camera, room, colours } = brush;
  const size = Math.max((camera.scale * ROBOT_MM) / 2, LEAST_PX);
  const dots: Dot[] = [];
  const behind: Dot[] = [];
  for (const one of seen) {
    if (one.actor.role === "keeper") continue;
    const [x, y] = toScreen(camera, one.pose.x_mm, one.pose.y_mm);
    if (x < -size || y < -size || x > room.width + size || y > room.height + size) continue;
    (program === "" || one.actor.program === program ? dots : behind).push({ x, y, one });
  }
  pen.globalAlpha = 0.3;
  arrows(brush, behind, size);
  fillWith(pen, colours.robotLine);
  pen.globalAlpha = 1;
  arrows(brush, dots, size);
  fillWith(pen, colours.robot);
  strokeWith(pen, colours.robotLine, Math.min(Math.max(size / 5, 0.8), 2));
  pen.beginPath();
  for (const { x, y, one } of dots) {
    if (one.pose.load > 0) pen.rect(x - size * 0.35, y - size * 0.35, size * 0.7, size * 0.7);
  }
  fillWith(pen, colours.box);
  const far = Math.max(size, 5);
  const of = (sign: "failed" | "stalled" | "muted") => dots.filter(({ one }) => one[sign]);
  signs(brush, of("failed"), (x, y) => {
    pen.moveTo(x - far, y - far);
    pen.lineTo(x + far, y + far);
    pen.moveTo(x + far, y - far);
    pen.lineTo(x - far, y + far);
  });
  signs(brush, of("stalled"), (x, y) => {
    pen.moveTo(x - far / 2, y - far);
    pen.lineTo(x - far / 2, y + far);
    pen.moveTo(x + far / 2, y - far);
    pen.lineTo(x + far / 2, y + far);
  });
  signs(brush, of("muted"), (x, y) => {
    pen.moveTo(x - far, y - far);
    pen.lineTo(x + far, y - far);
  });
}
