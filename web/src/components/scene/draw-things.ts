/** Boxes and balls that can be pushed, where they are: crates, and balls with a seam, on their shade. */
import type { World } from "../../model/types";
import { toScreen } from "./camera";
import { type Brush, drawBox } from "./draw-world";
import { fillWith, strokeWith } from "./ink";

export type Place = readonly [x_mm: number, y_mm: number];

/** A tennis ball, lit from the left above. */
function drawBall({ pen, colours }: Brush, x: number, y: number, radius: number): void {
  pen.beginPath();
  pen.ellipse(x + radius * 0.16, y + radius * 0.2, radius, radius * 0.96, 0, 0, Math.PI * 2);
  fillWith(pen, colours.shade);
  pen.save();
  pen.beginPath();
  pen.arc(x, y, radius, 0, Math.PI * 2);
  pen.clip();
  fillWith(pen, colours.ball);
  pen.beginPath();
  pen.arc(x - radius * 0.3, y - radius * 0.34, radius * 0.42, 0, Math.PI * 2);
  fillWith(pen, colours.ballLight);
  pen.lineWidth = Math.max(radius / 6, 1);
  pen.strokeStyle = colours.ballLine;
  for (const side of [-1, 1]) {
    pen.beginPath();
    pen.arc(x + side * radius * 1.35, y, radius, 0, Math.PI * 2);
    pen.stroke();
  }
  pen.restore();
  pen.beginPath();
  pen.arc(x, y, radius, 0, Math.PI * 2);
  strokeWith(pen, colours.robotLine, Math.max(radius / 12, 0.75));
}

/** `places` are those of a run, in the order of the world's things; without one a thing is where the world says. */
export function drawThings(brush: Brush, world: World, places: readonly Place[]): void {
  const { pen, camera } = brush;
  for (const [at, thing] of (world.things ?? []).entries()) {
    const [x, y] = toScreen(camera, ...(places[at] ?? ([thing.x_mm, thing.y_mm] as const)));
    const [width, height] = [thing.width_mm * camera.scale, thing.height_mm * camera.scale];
    if (thing.kind === "box") {
      pen.save();
      pen.translate(x - width / 2, y - height / 2);
      pen.scale(1, height / width);
      drawBox(brush, 0, 0, width);
      pen.restore();
      continue;
    }
    drawBall(brush, x, y, width / 2);
  }
}
