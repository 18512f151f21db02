/** What lies on the floor under the robots: zones, lines of pens, and things that can be pushed. Fetched when there is some. */
import { placesOfThings } from "../../session/poses";
import { drawThings } from "./draw-things";
import type { Brush } from "./draw-world";
import { drawZones } from "./draw-zones";
import { drawStrokes, strokesOfRun } from "./pen-strokes";
import type { Scene, Seen } from "./scene";

export function drawOnFloor(brush: Brush, scene: Scene, seen: readonly Seen[]): void {
  drawZones(brush, scene.world);
  if (scene.running) drawStrokes(brush, strokesOfRun(seen.map(({ pose }) => pose)));
  drawThings(brush, scene.world, scene.running ? placesOfThings() : []);
}
