/** The signs of what befell a robot, told apart by shape: ✕ failed, ‖ stalled, a struck-out wave without radio. */
import type { Brush } from "./draw-world";

/** Light under dark, so that it is seen on robot and road. */
function twice({ pen, colours, unit: u }: Brush, width: number): void {
  pen.lineCap = "round";
  pen.strokeStyle = colours.panel;
  pen.lineWidth = Math.max((width + 4) * u, 4);
  pen.stroke();
  pen.strokeStyle = colours.ink;
  pen.lineWidth = Math.max(width * u, 2);
  pen.stroke();
  pen.lineCap = "butt";
}

/** Over the robot, its middle at the origin. */
export function drawFailed(brush: Brush): void {
  const { pen, unit: u } = brush;
  pen.beginPath();
  pen.moveTo(-20 * u, -20 * u);
  pen.lineTo(20 * u, 20 * u);
  pen.moveTo(20 * u, -20 * u);
  pen.lineTo(-20 * u, 20 * u);
  twice(brush, 4);
}

/** Two bars, as of something that pauses. */
export function drawStalled(brush: Brush): void {
  const { pen, unit: u } = brush;
  pen.beginPath();
  for (const x of [-7, 7]) {
    pen.moveTo(x * u, -16 * u);
    pen.lineTo(x * u, 16 * u);
  }
  twice(brush, 5);
}

/** Waves with a line through them, over the robot's upper right. */
export function drawMuted(brush: Brush): void {
  const { pen, unit: u } = brush;
  const [x, y] = [20 * u, -14 * u];
  pen.beginPath();
  for (const reach of [6, 13]) {
    pen.moveTo(x + reach * Math.cos(-0.2) * u, y + reach * Math.sin(-0.2) * u);
    pen.arc(x, y, reach * u, -0.2, -1.4, true);
  }
  pen.moveTo(x - 2 * u, y - 16 * u);
  pen.lineTo(x + 16 * u, y + 2 * u);
  twice(brush, 2.5);
}
