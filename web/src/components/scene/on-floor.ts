/** What lies on the floor under the robots: zones, lines of pens, and things that can be pushed. Fetched when there is some. */
import { drawnByPens } from "../../session/pen-marks";
import { placesOfThings } from "../../session/poses";
import { drawThings } from "./draw-things";
import type { Brush } from "./draw-world";
import { drawZones } from "./draw-zones";
import { drawStrokes, strokesOf } from "./pen-strokes";
import type { Scene, Seen } from "./scene";

export function drawOnFloor(brush: Brush, scene: Scene, seen: readonly Seen[]): void {
  drawZones(brush, scene.world);
  const { marks, pens } = drawnByPens();
  if (scene.running) {
    const strokes = strokesOf(marks, (pen) => {
      const at = seen[pens[pen] ?? -1]?.pose;
      return at === undefined ? undefined : [at.x_mm, at.y_mm];
    });
    drawStrokes(brush, strokes);
  }
  drawThings(brush, scene.world, scene.running ? placesOfThings() : []);
}
