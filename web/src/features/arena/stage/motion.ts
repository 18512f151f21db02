/** How fast robots drive and turn, from the last two frames of a run, and where that leads. */
import type { Pose, PoseFrame } from "../../../api/wire";

const STEPS = 12;
/** Who drives slower than this, in mm a tick, has no way ahead. */
const SLOW_MM = 0.05;

export class Motion {
  private before: PoseFrame | null = null;
  private last: PoseFrame | null = null;

  clear(): void {
    this.before = null;
    this.last = null;
  }

  record(frame: PoseFrame): void {
    if (this.last?.tick === frame.tick) return;
    this.before = this.last !== null && this.last.tick < frame.tick ? this.last : null;
    this.last = frame;
  }

  /** Places on the way of the robot at `index` in so many ticks, from `pose`; none for one that stands. */
  ahead(index: number, pose: Pose, ticks: number): [number, number][] {
    const [a, b] = [this.before?.poses[index], this.last?.poses[index]];
    const span = (this.last?.tick ?? 0) - (this.before?.tick ?? 0);
    if (a === undefined || b === undefined || span <= 0) return [];
    const [dx, dy] = [b.x_mm - a.x_mm, b.y_mm - a.y_mm];
    const turned = Math.atan2(Math.sin(b.heading_rad - a.heading_rad), Math.cos(b.heading_rad - a.heading_rad)) / span;
    const forward = (dx * Math.cos(b.heading_rad) + dy * Math.sin(b.heading_rad)) / span;
    if (Math.abs(forward) < SLOW_MM) return [];
    let [x, y, heading] = [pose.x_mm, pose.y_mm, pose.heading_rad];
    const way: [number, number][] = [[x, y]];
    for (let step = 0; step < STEPS; step++) {
      heading += (turned * ticks) / STEPS;
      x += (Math.cos(heading) * forward * ticks) / STEPS;
      y += (Math.sin(heading) * forward * ticks) / STEPS;
      way.push([x, y]);
    }
    return way;
  }
}
