/** Signs of a robot's failures, different in shape: ✕ failed, ‖ stalled, a badge with a struck-out sender: no radio. */
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

/** A badge at the robot's upper right: a sender with its waves, struck out. */
export function drawMuted({ pen, colours, unit }: Brush): void {
  const u = Math.max(unit, 0.5);
  const [x, y] = [23 * u, -23 * u];
  pen.beginPath();
  pen.arc(x, y, 14 * u, 0, Math.PI * 2);
  pen.fillStyle = colours.panel;
  pen.fill();
  pen.strokeStyle = colours.ink;
  pen.lineWidth = 2 * u;
  pen.stroke();
  pen.beginPath();
  pen.arc(x, y + 6 * u, 2.2 * u, 0, Math.PI * 2);
  pen.fillStyle = colours.ink;
  pen.fill();
  pen.lineCap = "round";
  pen.beginPath();
  for (const reach of [6, 11]) {
    const from = -Math.PI * 0.75;
    pen.moveTo(x + reach * Math.cos(from) * u, y + (6 + reach * Math.sin(from)) * u);
    pen.arc(x, y + 6 * u, reach * u, from, -Math.PI * 0.25);
  }
  pen.moveTo(x - 9.5 * u, y - 9.5 * u);
  pen.lineTo(x + 9.5 * u, y + 9.5 * u);
  pen.stroke();
  pen.lineCap = "butt";
}
