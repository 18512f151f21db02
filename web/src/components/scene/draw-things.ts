/** Boxes and balls that can be pushed, drawn plainly where they are. */
import type { World } from "../../model/types";
import { toScreen } from "./camera";
import { type Brush, drawBox } from "./draw-world";

export type Place = readonly [x_mm: number, y_mm: number];

/** `places` are those of a run, in the order of the world's things; without one a thing is where the world says. */
export function drawThings(brush: Brush, world: World, places: readonly Place[]): void {
  const { pen, camera, colours } = brush;
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
    pen.beginPath();
    pen.arc(x, y, width / 2, 0, Math.PI * 2);
    pen.fillStyle = colours.bed;
    pen.fill();
    pen.strokeStyle = colours.robotLine;
    pen.lineWidth = Math.max(width / 18, 0.75);
    pen.stroke();
  }
}
