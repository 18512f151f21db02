/**
 * Paints the arena on a canvas when something has changed, and only then.
 *
 * Where the camera is says `Viewpoint`. Robots are on the move between two frames, so painting goes on until they stand where
 * the last frame says.
 */
import { moreWords } from "../../i18n/words";
import type { World } from "../../model/types";
import { drawnByPens } from "../../session/pen-marks";
import { posesAt } from "../../session/poses";
import { listen } from "../../ui/effects";
import { type Box, type Camera, fit, fitBox, type Room, toScreen, toWorld, zoomAt } from "./camera";
import { type Colours, readColours } from "./colours";
import { CROWD } from "./crowd-size";
import { type Boards, drawActors, drawRing, ringOf, type Said, type Seldom } from "./draw-robots";
import { type Brush, drawWorld, robotUnit, unitOf } from "./draw-world";
import { contentOf, EMPTY, subjectOf } from "./framing";
import type * as OnFloorChunk from "./on-floor";
import { lookAt, type Scene, type Seen } from "./scene";
import { Viewpoint } from "./viewpoint";

type OnFloor = typeof OnFloorChunk;

const WALL_MARGIN = 26;
/** How far from a robot a hand may be to take it, in px. */
const LEAST_REACH = 18;
/** How close the camera goes to follow somebody: times the scale that shows the whole world. */
const FOLLOW = 2;

/** What is drawn besides, under the robots and over them; true when it goes on moving by itself. */
export interface Layers {
  /** Under what pens drew. */
  ground: (brush: Brush, scene: Scene, seen: readonly Seen[]) => void;
  under: (brush: Brush, scene: Scene, seen: readonly Seen[]) => boolean;
  over: (brush: Brush, scene: Scene, seen: readonly Seen[]) => boolean;
  /** Where robots have been. */
  been: () => Box;
  /** Closes what is said of a robot at a point of the canvas; false where nothing is. */
  closeTagAt: (x: number, y: number) => boolean;
}

export class Painter {
  private readonly canvas: HTMLCanvasElement;
  private room: Room = { width: 0, height: 0 };
  readonly viewpoint = new Viewpoint({ whole: (free) => this.whole(free), subject: (free) => this.subject(free) });
  private scene: Scene | null = null;
  private selected = "";
  private program = "";
  private followed = "";
  private colours: Colours | null = null;
  private request = 0;
  private readonly smooth: () => boolean;

  private readonly seenFrom: (camera: Camera) => void;
  private readonly margin: number | null;
  private told: Camera | null = null;
  private seldom: Seldom = { boards: null, crowds: null, figures: null };
  private said: Said = { place: true, names: false };
  private layers: Layers | null = null;
  private fetching = false;
  private onFloor: OnFloor | null = null;
  private carried: { name: string; x_mm: number; y_mm: number } | null = null;

  /** `seenFrom` is told where the eye is, whenever that changes; `margin` is the room around the world in px. */
  constructor(
    canvas: HTMLCanvasElement,
    smooth: () => boolean,
    seenFrom: (camera: Camera) => void = () => undefined,
    margin: number | null = null,
  ) {
    this.canvas = canvas;
    this.smooth = smooth;
    this.seenFrom = seenFrom;
    this.margin = margin;
  }

  /** Shows a robot at a point of the canvas, until it is put down. */
  carry(name: string, x: number, y: number): void {
    const [x_mm, y_mm] = toWorld(this.camera, x, y);
    this.carried = { name, x_mm, y_mm };
    this.paintSoon();
  }

  putDown(): void {
    this.carried = null;
    this.paintSoon();
  }

  /** Where the eye is. */
  get camera(): Camera {
    return this.viewpoint.camera;
  }

  setScene(scene: Scene, selected: string): void {
    const [before, now] = [this.scene?.world, scene.world];
    const size = ({ name, width_mm, height_mm }: World) => [name, width_mm, height_mm].join(" ");
    // An edit of the world leaves the eye where it is.
    const other = before === undefined || size(before) !== size(now);
    this.scene = scene;
    this.selected = selected;
    this.fetchSeldom(scene);
    if (other) this.viewpoint.begin();
    this.paintSoon();
  }

  /** Robots of this program stand out, "" for all alike; the followed one stays in the middle, "" for nobody. */
  setView(program: string, followed: string): void {
    this.program = program;
    if (followed !== "" && followed !== this.followed) {
      const whole = this.whole().scale;
      if (this.camera.scale < FOLLOW * whole) this.zoom((FOLLOW * whole) / this.camera.scale);
    }
    this.followed = followed;
    this.paintSoon();
  }

  /** How much is said of robots, and what is drawn besides. */
  setLayers(said: Said, layers: Layers | null): void {
    this.said = said;
    this.layers = layers;
    this.paintSoon();
  }

  themeChanged(): void {
    this.colours = null;
    this.paintSoon();
  }

  resize(width: number, height: number): void {
    this.room = { width, height };
    const ratio = window.devicePixelRatio || 1;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.viewpoint.jump(this.room);
    this.paint();
  }

  private whole(room = this.room): Camera {
    const world = this.scene?.world;
    if (world === undefined) return this.camera;
    // Who draws a world sees all of it; who runs one sees what is there.
    if (this.margin !== null) return fit(world, room, this.margin);
    const poses = this.seen(performance.now()).seen.map(({ pose }) => pose);
    return fitBox(contentOf(world, poses), room, world.walls.length > 0 ? WALL_MARGIN : 0);
  }

  /** What is to be seen of that; null for all of it. */
  private subject(room: Room): Box | null {
    const scene = this.scene;
    if (scene === null || this.margin !== null) return null;
    const robots = this.seen(performance.now()).seen.map(({ actor, pose }) => ({
      ...pose,
      length_mm: actor.length_mm,
    }));
    const been = scene.running ? (this.layers?.been() ?? EMPTY) : EMPTY;
    return subjectOf(scene.world, robots, been, this.whole(room), room);
  }

  showAll(): void {
    this.viewpoint.showAll();
    this.paintSoon();
  }

  showSubject(): void {
    this.viewpoint.showSubject();
    this.paintSoon();
  }

  /** A run begins, or what it did can be looked at whole. */
  setOpen(open: boolean): void {
    this.viewpoint.setOpen(open);
    this.paintSoon();
  }

  /** So many px at the bottom are covered. */
  setCovered(px: number): void {
    this.viewpoint.setCovered(px);
    this.paintSoon();
  }

  zoom(factor: number, x = this.room.width / 2, y = this.room.height / 2): void {
    this.viewpoint.take(zoomAt(this.camera, this.whole(), factor, x, y));
    this.paintSoon();
  }

  pan(dx: number, dy: number): void {
    this.viewpoint.take({ ...this.camera, x: this.camera.x + dx, y: this.camera.y + dy });
    this.paintSoon();
  }

  /** Who is under a point of the canvas. */
  actorAt(x: number, y: number): Seen | null {
    if (this.scene === null) return null;
    const unit = unitOf(this.camera, this.scene.world);
    let best: { seen: Seen; off: number } | null = null;
    const everybody = this.seen(performance.now()).seen;
    for (const seen of everybody) {
      if (seen.actor.role === "keeper") continue;
      const reach =
        seen.actor.face === null
          ? Math.max(ringOf({ role: "robot" }, robotUnit(this.camera, seen.actor.length_mm)), LEAST_REACH)
          : 34 * (this.boards?.boardUnit(unit, everybody.length) ?? unit);
      const [sx, sy] = toScreen(this.camera, seen.pose.x_mm, seen.pose.y_mm);
      const off = Math.hypot(sx - x, sy - y);
      if (off < reach && (best === null || off < best.off)) best = { seen, off };
    }
    return best?.seen ?? null;
  }

  /** Figures, boards and crowds are drawn once the means are there. */
  private fetchSeldom({ actors }: Scene): void {
    const boards =
      this.seldom.boards === null &&
      actors.some(({ face, keys, indicators }) => face !== null || keys.length + indicators.length > 0);
    const crowds = this.seldom.crowds === null && actors.length >= CROWD;
    const figures = this.seldom.figures === null && actors.length > 0;
    if (!boards && !crowds && !figures) return;
    this.fetch(async () => {
      const [drawBoards, drawCrowds, drawn] = await Promise.all([
        boards ? import("./draw-board") : this.seldom.boards,
        crowds ? import("./draw-crowd") : this.seldom.crowds,
        figures ? import("./figures") : this.seldom.figures,
      ]);
      this.seldom = { boards: drawBoards, crowds: drawCrowds, figures: drawn };
    });
  }

  /** Paints with what was fetched; one fetch at a time, and one that failed is tried again. */
  private fetch(chunks: () => Promise<void>): void {
    if (this.fetching) return;
    this.fetching = true;
    void chunks()
      .then(() => this.paintSoon())
      .catch(() => undefined)
      .finally(() => {
        this.fetching = false;
      });
  }

  closeTagAt(x: number, y: number): boolean {
    return this.layers?.closeTagAt(x, y) === true;
  }

  /** What a hand does to boards; null until it was fetched. */
  get boards(): Boards | null {
    return this.seldom.boards;
  }

  /** The button of a board under a point of the canvas: the robot, and the sensor that feels it. */
  keyAt(x: number, y: number): { agent: string; sensor: string } | null {
    if (this.scene === null || this.boards === null) return null;
    const { seen } = this.seen(performance.now());
    const unit = this.boards.boardUnit(unitOf(this.camera, this.scene.world), seen.length);
    return this.boards.keyAt({ camera: this.camera, unit }, seen, x, y);
  }

  /** Where an actor is on the canvas; null when there is no such one. */
  placeOf(name: string): [x: number, y: number] | null {
    const one = this.seen(performance.now()).seen.find(({ actor }) => actor.name === name);
    return one === undefined ? null : toScreen(this.camera, one.pose.x_mm, one.pose.y_mm);
  }

  /** Moves the camera with the one who is followed. */
  private keepUp(seen: readonly Seen[]): void {
    const one = this.followed === "" ? undefined : seen.find(({ actor }) => actor.name === this.followed);
    if (one === undefined) return;
    const { scale } = this.camera;
    const { width, height } = this.room;
    this.viewpoint.take({
      scale,
      x: width / 2 - one.pose.x_mm * scale,
      y: height / 2 + one.pose.y_mm * scale,
    });
  }

  private seen(now: number): { seen: Seen[]; still: boolean } {
    if (this.scene === null) return { seen: [], still: true };
    const shown = this.scene.running ? posesAt(now, this.smooth()) : null;
    const { carried } = this;
    const seen = lookAt(this.scene, shown?.poses ?? null).map((one) =>
      one.actor.name === carried?.name
        ? { ...one, pose: { ...one.pose, x_mm: carried.x_mm, y_mm: carried.y_mm } }
        : one,
    );
    return { seen, still: shown?.still ?? true };
  }

  paintSoon(): void {
    if (this.request !== 0) return;
    this.request = requestAnimationFrame(() => {
      this.request = 0;
      this.paint();
    });
  }

  private paint(): void {
    const pen = this.canvas.getContext("2d");
    if (pen === null || this.scene === null || this.room.width === 0) return;
    const { seen, still } = this.seen(performance.now());
    this.keepUp(seen);
    const eases = this.viewpoint.step(this.scene.running, this.smooth());
    const ratio = window.devicePixelRatio || 1;
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.colours ??= readColours();
    const { camera, room, colours } = this;
    if (camera !== this.told) {
      this.told = camera;
      this.seenFrom(camera);
    }
    const brush = { pen, camera, room, unit: unitOf(camera, this.scene.world), colours };
    drawWorld(brush, this.scene);
    drawRing(brush, seen, this.selected);
    this.layers?.ground(brush, this.scene, seen);
    this.drawOnFloor(brush, seen);
    const moves = this.layers?.under(brush, this.scene, seen) === true;
    const said = { ...this.said, place: this.said.place && !this.viewpoint.isCovered };
    drawActors(brush, this.scene, seen, this.selected, this.program, this.seldom, said);
    if (this.layers?.over(brush, this.scene, seen) === true || moves || eases || !still) this.paintSoon();
  }

  /** Fetches what draws there once there is something. */
  private drawOnFloor(brush: Brush, seen: readonly Seen[]): void {
    const scene = this.scene;
    if (scene === null) return;
    const { things = [], zones = [] } = scene.world;
    if (drawnByPens().marks.length + things.length + zones.length === 0) return;
    if (this.onFloor !== null) this.onFloor.drawOnFloor(brush, scene, seen);
    else
      this.fetch(async () => {
        [this.onFloor] = await Promise.all([import("./on-floor"), moreWords()]);
      });
  }

  /** Fills a frame and is zoomed by the wheel over an element; returns what ends all of it. */
  attachTo(frame: HTMLElement, wheelOver: HTMLElement = frame): () => void {
    const watcher = new ResizeObserver(([entry]) => {
      if (entry !== undefined) this.resize(entry.contentRect.width, entry.contentRect.height);
    });
    watcher.observe(frame);
    // A wheel listener that may prevent scrolling cannot be passive, as React's are.
    const wheel = (event: WheelEvent) => {
      event.preventDefault();
      const place = wheelOver.getBoundingClientRect();
      this.zoom(Math.exp(-event.deltaY * 0.0015), event.clientX - place.left, event.clientY - place.top);
    };
    const endWheel = listen(wheelOver, { wheel }, { passive: false });
    void document.fonts?.ready.then(() => this.paintSoon());
    return () => {
      watcher.disconnect();
      endWheel();
      cancelAnimationFrame(this.request);
    };
  }
}
