/**
 * Where robots have been, as dots of 3 px each 8 px in the colour of each.
 *
 * Of each robot the places it went through are kept, in mm, with their ticks: so a run that goes back loses what lay ahead.
 * Between frames that are far apart in time nobody saw which way it went: there is one dot where it was then. The
 * dots are drawn once onto a layer that is larger than the arena, and that is moved along with the camera; only what is
 * new is added to it. Another scale, or the edge of the layer, draws it anew.
 */
import type { PoseFrame } from "../../../api/wire";
import type { Box, Camera } from "../../../components/scene/camera";
import type { Brush } from "../../../components/scene/draw-world";
import { around, EMPTY, union } from "../../../components/scene/framing";

const [DOT_PX, EACH_PX] = [3, 8];
/** Places nearer than this to the last one are not kept, in mm. */
const LEAST_MM = 10;
/** Further than this within one frame it did not drive, in mm. */
const JUMP_MM = 2000;
/** Frames further apart than this are not joined, in ticks: 0.6 s. Of a faster run the way between two frames comes too. */
const APART_TICKS = 30;
/** Room of the layer around the arena, in px. */
const MARGIN = 200;
/** So many places are kept of all robots together, and of each at least and at most so many. */
const [ALL, FEWEST, MOST] = [400_000, 100, 4000];

interface Trail {
  xs: number[];
  ys: number[];
  ticks: number[];
  /** Whether it was seen on its way to a place from the one before. */
  seen: boolean[];
  /** How long the way was that is not kept any more, in mm. */
  before: number;
  /** So many of its places are on the layer, and how far the last dot is behind the last of them, in px. */
  drawn: number;
  behind: number;
}

function empty(): Trail {
  return { xs: [], ys: [], ticks: [], seen: [], before: 0, drawn: 0, behind: 0 };
}

export class Trails {
  private trails: Trail[] = [];
  private tick = -1;
  private layer: OffscreenCanvas | null = null;
  private at: Camera = { scale: 0, x: 0, y: 0 };
  private ratio = 1;
  private stale = true;
  private colours = "";
  private box: Box | null = null;

  clear(): void {
    this.trails = [];
    this.tick = -1;
    this.stale = true;
    this.box = null;
  }

  /** Where robots have been. */
  get been(): Box {
    this.box ??= this.trails.reduce(
      (box, { xs, ys }) => xs.reduce((so, x, at) => union(so, around(x, ys[at] ?? 0, 0)), box),
      EMPTY,
    );
    return this.box;
  }

  /** The places of each robot that are kept, in mm, with their ticks. */
  get ways(): readonly Pick<Trail, "xs" | "ys" | "ticks">[] {
    return this.trails;
  }

  /** How far each robot drove, in mm. */
  get driven(): number[] {
    return this.trails.map(({ before, xs }, at) => before + xs.reduce((sum, _, end) => sum + this.piece(at, end), 0));
  }

  /** How long the way of a robot to a place is, from the one before. */
  private piece(at: number, end: number): number {
    const { xs = [], ys = [] } = this.trails[at] ?? {};
    if (end < 1) return 0;
    const long = Math.hypot((xs[end] ?? 0) - (xs[end - 1] ?? 0), (ys[end] ?? 0) - (ys[end - 1] ?? 0));
    return long > JUMP_MM ? 0 : long;
  }

  /** The places of each robot that are kept. */
  get lengths(): number[] {
    return this.trails.map(({ xs }) => xs.length);
  }

  /** Of each robot how many places it was not seen on its way to; they stand alone. */
  get apart(): number[] {
    return this.trails.map(({ seen }) => seen.filter((one) => !one).length);
  }

  /** `joined`: it follows on the one before, however far apart they are. */
  record({ tick, poses }: PoseFrame, joined = false): void {
    if (this.trails.length !== poses.length) {
      this.trails = poses.map(empty);
      this.stale = true;
    }
    if (tick < this.tick) this.forget(tick);
    const close = joined || tick - this.tick <= APART_TICKS;
    this.tick = tick;
    const most = Math.min(MOST, Math.max(FEWEST, Math.floor(ALL / Math.max(poses.length, 1))));
    poses.forEach(({ x_mm, y_mm }, index) => {
      const trail = this.trails[index];
      if (trail === undefined) return;
      const { xs, ys, ticks, seen } = trail;
      const end = xs.length - 1;
      const far = end < 0 ? Infinity : Math.hypot(x_mm - (xs[end] ?? 0), y_mm - (ys[end] ?? 0));
      if (far < LEAST_MM) return;
      if (this.box !== null) this.box = union(this.box, around(x_mm, y_mm, 0));
      xs.push(x_mm);
      ys.push(y_mm);
      ticks.push(tick);
      seen.push(close);
      if (xs.length <= most * 1.25) return;
      // The oldest go, many at a time: each time the layer is drawn anew.
      const gone = xs.length - most;
      for (let end = 1; end <= gone; end++) trail.before += this.piece(index, end);
      this.box = null;
      for (const list of [xs, ys, ticks, seen]) list.splice(0, gone);
      this.stale = true;
    });
  }

  /** Forgets what is later than a tick: what comes next follows on the last place that is left. */
  private forget(tick: number): void {
    this.tick = -Infinity;
    this.box = null;
    for (const { xs, ys, ticks, seen } of this.trails) {
      let left = ticks.length;
      while (left > 0 && (ticks[left - 1] ?? 0) > tick) left--;
      for (const list of [xs, ys, ticks, seen]) list.length = left;
      this.tick = Math.max(this.tick, ticks.at(-1) ?? -Infinity);
    }
    this.stale = true;
  }

  /** `colourOf`: of the robot at a place of the team. */
  draw({ pen, camera, room }: Brush, colourOf: (index: number) => string): void {
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [(room.width + 2 * MARGIN) * ratio, (room.height + 2 * MARGIN) * ratio].map(Math.ceil);
    if (width === undefined || height === undefined) return;
    const [dx, dy] = [camera.x - this.at.x, camera.y - this.at.y];
    const colours = colourOf(0);
    if (
      this.layer === null ||
      this.layer.width !== width ||
      this.layer.height !== height ||
      this.at.scale !== camera.scale ||
      Math.abs(dx) > MARGIN ||
      Math.abs(dy) > MARGIN ||
      colours !== this.colours
    ) {
      if (this.layer?.width !== width || this.layer.height !== height) this.layer = new OffscreenCanvas(width, height);
      this.at = { ...camera };
      this.ratio = ratio;
      this.colours = colours;
      this.stale = true;
    }
    const paint = this.layer.getContext("2d");
    if (paint === null) return;
    if (this.stale) {
      paint.setTransform(1, 0, 0, 1, 0, 0);
      paint.clearRect(0, 0, width, height);
      for (const trail of this.trails) Object.assign(trail, { drawn: 0, behind: 0 });
      this.stale = false;
    }
    paint.setTransform(this.ratio, 0, 0, this.ratio, MARGIN * this.ratio, MARGIN * this.ratio);
    this.trails.forEach((trail, index) => {
      if (trail.drawn >= trail.xs.length) return;
      paint.fillStyle = colourOf(index);
      this.add(paint, trail);
    });
    pen.drawImage(
      this.layer,
      camera.x - this.at.x - MARGIN,
      camera.y - this.at.y - MARGIN,
      width / this.ratio,
      height / this.ratio,
    );
  }

  /** The dots of what is not on the layer yet. */
  private add(paint: OffscreenCanvasRenderingContext2D, trail: Trail): void {
    const { scale, x, y } = this.at;
    const { xs, ys, seen } = trail;
    for (let end = Math.max(trail.drawn, 1); end < xs.length; end++) {
      const [x0, y0] = [x + (xs[end - 1] ?? 0) * scale, y - (ys[end - 1] ?? 0) * scale];
      const [x1, y1] = [x + (xs[end] ?? 0) * scale, y - (ys[end] ?? 0) * scale];
      const long = Math.hypot(x1 - x0, y1 - y0);
      if (long === 0 || long > JUMP_MM * scale) continue;
      if (seen[end] !== true) {
        this.dot(paint, x1, y1);
        trail.behind = 0;
        continue;
      }
      let along = EACH_PX - trail.behind;
      for (; along <= long; along += EACH_PX) {
        const share = along / long;
        this.dot(paint, x0 + (x1 - x0) * share, y0 + (y1 - y0) * share);
      }
      trail.behind = long - (along - EACH_PX);
    }
    trail.drawn = xs.length;
  }

  private dot(paint: OffscreenCanvasRenderingContext2D, x: number, y: number): void {
    if (this.trails.length > 100) {
      paint.fillRect(x - DOT_PX / 2, y - DOT_PX / 2, DOT_PX, DOT_PX);
      return;
    }
    paint.beginPath();
    paint.arc(x, y, DOT_PX / 2, 0, Math.PI * 2);
    paint.fill();
  }
}
