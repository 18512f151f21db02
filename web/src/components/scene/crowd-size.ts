/** When there are so many robots that they are drawn simply; how is in `draw-crowd.ts`, which is fetched then. */
import { ROBOT_MM } from "./geometry";

/** From so many robots on they are drawn simply, while they are small. */
export const CROWD = 150;
/** Robots shorter than this on the screen are small, in px. */
const SMALL_PX = 26;

/** Whether the robots are to be drawn simply; `scale` is px a mm. */
export function isCrowd(robots: number, scale: number): boolean {
  return robots >= CROWD && scale * ROBOT_MM < SMALL_PX;
}
