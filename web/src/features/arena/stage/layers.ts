/**
 * What the arena shows besides the world and the robots while something runs: trails, rays, ranges of radio, the way ahead, and
 * a small celebration. Under the robots lies what is on the floor, over them only words and paper.
 */
import type { PoseFrame } from "../../../api/wire";
import { type Box, toScreen } from "../../../components/scene/camera";
import { type Brush, robotUnit, write } from "../../../components/scene/draw-world";
import { ROBOT_MM } from "../../../components/scene/geometry";
import { fillWith, strokeWith } from "../../../components/scene/ink";
import { LIDS } from "../../../components/scene/lids";
import type { Layers } from "../../../components/scene/painter";
import { PEN_COLOURS, type PenStroke, strokesOfRun } from "../../../components/scene/pen-strokes";
import type { Scene, Seen } from "../../../components/scene/scene";
import type { Area } from "../../../components/scene/tag-place";
import { decimal } from "../../../i18n/numbers";
import { useStudio } from "../../../model/studio";
import { openLesson, useLessons } from "../../../session/lessons";
import { isLive, type RunState, useRun } from "../../../session/run";
import { fontOf, token, useTheme } from "../../../theme";
import { endAll } from "../../../ui/effects";
import type { Facts } from "./account";
import { awaitedAt } from "./awaited-sensors";
import { Confetti, reachedGoal } from "./confetti";
import { Motion } from "./motion";
import { type Ray, raysOf } from "./rays";
import { RunDiary } from "./run-diary";
import { drawGlows, drawSigns, drawTag, lineAreas } from "./signs";
import { flip, type Shows } from "./switches";
import { Trails } from "./trails";

/** Of more robots than this only those that are watched have rays and ranges. */
const MANY = 24;
const SOON_S = 1.2;

interface Tints {
  line: string;
  tint: string;
  word: string;
}

type Colours = Brush["colours"];

const tints = new WeakMap<Colours, Tints>();

/** Sensors have the colours of tests. */
function tintsOf(colours: Colours): Tints {
  let found = tints.get(colours);
  if (found === undefined) {
    found = { line: token("test-line"), tint: token("test-tint"), word: token("test-word") };
    tints.set(colours, found);
  }
  return found;
}

function lineColour(lid: number): string {
  const dark = useTheme.getState().theme !== "light";
  return LIDS[lid]?.[dark ? "dark" : "light"] ?? "#888";
}

export class StageLayers implements Layers {
  private readonly trails = new Trails();
  private readonly motion = new Motion();
  private readonly diary = new RunDiary();
  private readonly confetti: Confetti;
  private run = "";
  private on: Readonly<Record<Shows, boolean>> | null = null;
  private selected = "";
  private tag = true;
  /** Where the tag of the one that is watched stands. */
  private tagArea: Area | null = null;
  /** What was found for the rays in this frame; drawn under the robots, labelled over them. */
  private rays: { ray: Ray; own: boolean }[] = [];

  constructor(again: () => void) {
    this.confetti = new Confetti(again);
  }

  /** A run begins, or there is none any more. */
  begin(run: string): void {
    if (run === this.run) return;
    this.run = run;
    this.trails.clear();
    this.motion.clear();
    this.diary.clear();
    this.confetti.clear();
  }

  /** `joined`: the frame follows on the one before, however far apart they are. */
  record(frame: PoseFrame, joined: boolean): void {
    // A short run is over before anything of the page was drawn for it.
    this.begin(useRun.getState().name);
    this.trails.record(frame, joined);
    this.motion.record(frame);
    this.diary.record(frame);
    this.diary.look(useRun.getState());
  }

  been(): Box {
    return this.trails.been;
  }

  facts(run: RunState): Facts {
    this.diary.look(run);
    return this.diary.facts(run, this.trails);
  }

  /** Closes the tag where it stands at a point of the canvas. */
  closeTagAt(x: number, y: number): boolean {
    const { tagArea: at } = this;
    if (at === null || x < at.left || x > at.left + at.width || y < at.top || y > at.top + at.height) return false;
    flip("tag");
    return true;
  }

  /** `tag`: whether what the robot that is watched senses stands beside it. */
  show(on: Readonly<Record<Shows, boolean>>, selected: string, tag: boolean): void {
    this.on = on;
    this.selected = selected;
    this.tag = tag;
  }

  /** Celebrates when a run reaches its goal, and when a lesson is done; the returned function ends that. */
  celebrateGoals(): () => void {
    const offRun = useRun.subscribe((now, before) => {
      if (now.status === before.status) return;
      if (reachedGoal(now)) this.confetti.begin();
      else if (now.status === "running") this.confetti.clear();
    });
    const offLessons = useLessons.subscribe((now, before) => {
      const [lesson, was] = [openLesson(now), openLesson(before)];
      if (lesson?.done === true && was?.name === lesson.name && !was.done) this.confetti.begin();
    });
    return endAll(offRun, offLessons);
  }

  private stands(seen: Seen, count: number): boolean {
    return seen.actor.name === this.selected || count <= MANY;
  }

  /** Trails and rays lie under what pens drew: a drawn line is never dotted. Who has ended looks at nothing any more. */
  ground(brush: Brush, scene: Scene, seen: readonly Seen[]): void {
    this.rays = [];
    if (this.on === null || !scene.running || scene.real) return;
    if (this.on.trails) this.trails.draw(brush, (index) => lineColour(scene.actors[index]?.lid ?? 0));
    if (this.on.rays && isLive(useRun.getState().status)) this.drawRays(brush, seen);
  }

  under(brush: Brush, scene: Scene, seen: readonly Seen[]): boolean {
    if (this.on === null || !scene.running || scene.real) return false;
    if (this.on.radio) this.drawRadio(brush, seen);
    if (this.on.ahead) this.drawAhead(brush, seen);
    drawGlows(brush, seen);
    return false;
  }

  over(brush: Brush, scene: Scene, seen: readonly Seen[]): boolean {
    if (scene.running) {
      this.drawPenTips(brush, seen);
      drawSigns(brush, scene, seen);
    }
    const tagged = this.tag && this.on?.tag === true && isLive(useRun.getState().status);
    const watched = tagged ? seen.find(({ actor }) => actor.name === this.selected) : undefined;
    const rays = this.rays.filter(({ ray, own }) => own && ray.ends);
    // Words keep clear of what pens drew.
    const lines = watched === undefined && rays.length === 0 ? [] : strokesOfRun(seen.map(({ pose }) => pose));
    // A board shows itself; what it senses changes all the time.
    this.tagArea =
      watched === undefined || watched.actor.face !== null
        ? null
        : drawTag(brush, scene, seen, watched, { awaited: this.awaited(watched), lines });
    for (const { ray } of rays) this.label(brush, ray, lines);
    return this.confetti.draw(brush);
  }

  private awaited({ actor }: Seen): ReadonlySet<string> {
    const { mission, agents } = useRun.getState();
    const program = mission?.programs.find(({ name }) => name === actor.program);
    const active = agents.find(({ name }) => name === actor.name)?.active ?? [];
    return program === undefined
      ? new Set()
      : awaitedAt(
          program,
          active.map(([, vertex]) => vertex),
        );
  }

  /** On robots whose pen is down: its tip, in its colour. */
  private drawPenTips({ pen, camera, colours }: Brush, seen: readonly Seen[]): void {
    const { agents } = useRun.getState();
    const { robots } = useStudio.getState().catalogue;
    seen.forEach((one, index) => {
      const agent = agents[index];
      if (agent === undefined || !this.stands(one, seen.length)) return;
      const tool = robots.find(({ name }) => name === agent.robot)?.objects.find(({ look }) => look === "pen");
      const [down = 0, colour = 0] = tool === undefined ? [] : (agent.shown[tool.name] ?? []);
      if (down === 0) return;
      const unit = robotUnit(camera, one.actor.length_mm);
      const [x, y] = toScreen(camera, one.pose.x_mm, one.pose.y_mm);
      pen.beginPath();
      pen.arc(x, y, 3.6 * unit, 0, Math.PI * 2);
      fillWith(pen, PEN_COLOURS[colour] ?? colours.ink);
      strokeWith(pen, colours.robotLine, Math.max(1.5 * unit, 1));
    });
  }

  private drawRadio({ pen, camera, colours }: Brush, seen: readonly Seen[]): void {
    const reach = useRun.getState().mission?.radio?.range_mm ?? 0;
    if (reach <= 0) return;
    pen.setLineDash([4, 5]);
    pen.strokeStyle = colours.muted;
    pen.lineWidth = 1.25;
    for (const one of seen) {
      if (!this.stands(one, seen.length)) continue;
      const [x, y] = toScreen(camera, one.pose.x_mm, one.pose.y_mm);
      pen.beginPath();
      pen.arc(x, y, reach * camera.scale, 0, Math.PI * 2);
      pen.stroke();
    }
    pen.setLineDash([]);
  }

  /** Where robots will be soon when they go on as they do. */
  private drawAhead({ pen, camera }: Brush, seen: readonly Seen[]): void {
    const { tickMs } = useRun.getState();
    seen.forEach((one, index) => {
      if (!this.stands(one, seen.length) || one.actor.role !== "robot") return;
      const way = this.motion.ahead(index, one.pose, (SOON_S * 1000) / tickMs);
      if (way.length === 0) return;
      pen.beginPath();
      for (const [x, y] of way) pen.lineTo(...toScreen(camera, x, y));
      pen.setLineDash([1, 6]);
      pen.lineCap = "round";
      strokeWith(pen, lineColour(one.actor.lid), 3);
      pen.setLineDash([]);
      const [tip, from] = [way.at(-1), way.at(-2)];
      if (tip === undefined || from === undefined) return;
      const [x, y] = toScreen(camera, ...tip);
      const turn = Math.atan2(tip[1] - from[1], tip[0] - from[0]);
      pen.beginPath();
      for (const side of [2.6, 0, -2.6]) {
        const length = side === 0 ? 0 : 8;
        pen.lineTo(x + Math.cos(turn + side) * length, y - Math.sin(turn + side) * length);
      }
      pen.stroke();
      pen.lineCap = "butt";
    });
  }

  private drawRays(brush: Brush, seen: readonly Seen[]): void {
    const { pen, camera, colours } = brush;
    const { agents } = useRun.getState();
    const { catalogue } = useStudio.getState();
    const alone = seen.filter(({ actor }) => actor.role === "robot").length === 1;
    const { line } = tintsOf(colours);
    seen.forEach((one, index) => {
      const agent = agents[index];
      if (agent === undefined || !this.stands(one, seen.length)) return;
      const robot = catalogue.robots.find(({ name }) => name === agent.robot);
      const own = alone || one.actor.name === this.selected;
      for (const ray of raysOf(robot, agent.inputs, one)) this.rays.push({ ray, own });
    });
    pen.strokeStyle = line;
    for (const { ray, own } of this.rays) {
      const from = toScreen(camera, ...ray.from);
      const to = toScreen(camera, ...ray.to);
      pen.lineWidth = own ? 2 : 1.25;
      pen.setLineDash([6, 4]);
      pen.beginPath();
      pen.moveTo(...from);
      pen.lineTo(...to);
      pen.stroke();
      pen.setLineDash([]);
      if (!ray.ends) continue;
      pen.beginPath();
      pen.arc(...to, 7, 0, Math.PI * 2);
      pen.lineWidth = 1.5;
      pen.stroke();
      pen.beginPath();
      pen.arc(...to, 3.5, 0, Math.PI * 2);
      fillWith(pen, line);
    }
  }

  /** The length of a ray at its middle, beside its robot where it is short. */
  private label(brush: Brush, { from, to, mm }: Ray, lines: readonly PenStroke[]): void {
    const { pen, camera, room, colours } = brush;
    const { line, tint, word } = tintsOf(colours);
    const [ax, ay] = toScreen(camera, ...from);
    const [bx, by] = toScreen(camera, ...to);
    const words = `${decimal(Math.round(mm) / 10)} cm`;
    pen.font = fontOf(600, 13);
    const width = pen.measureText(words).width + 16;
    const long = Math.hypot(bx - ax, by - ay);
    const clear = robotUnit(camera, ROBOT_MM) * 30;
    // Off the ray where the chip would cover the robot or what it sees.
    const off = long < width + clear ? 24 : 0;
    const [ux, uy] = long === 0 ? [0, -1] : [(bx - ax) / long, (by - ay) / long];
    const inside = (value: number, most: number) => Math.min(Math.max(value, 0), Math.max(most, 0));
    const left = inside((ax + bx) / 2 + uy * off - width / 2, room.width - width);
    const top = inside((ay + by) / 2 - ux * off - 12, room.height - 24);
    if (lineAreas(camera, lines, { left, top, width, height: 24 }).length > 0) return;
    pen.beginPath();
    pen.roundRect(left, top, width, 24, 5);
    fillWith(pen, tint);
    strokeWith(pen, line, 1);
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    write(brush, words, left + width / 2, top + 12.5, 13, 600, word);
  }
}
