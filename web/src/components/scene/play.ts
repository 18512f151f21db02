/**
 * A run in a small picture: frames of a preview, drawn as the arena draws them, at any moment between the first and the last.
 *
 * Left to others: when it is which moment (`RunPicture`), and where previews come from.
 */
import type { RunPreview } from "../../api/generated";
import type { Pose } from "../../api/wire";
import type { PenMark } from "../../session/pen-marks";
import type { Catalogue, World } from "../../model/types";
import { type Box, fitBox, type Room, toScreen } from "./camera";
import type { Colours } from "./colours";
import * as boards from "./draw-board";
import { drawActors, type Seldom } from "./draw-robots";
import { drawThings, type Place } from "./draw-things";
import { type Brush, drawWorld, unitOf } from "./draw-world";
import * as figures from "./figures";
import { contentOf } from "./framing";
import { LIDS } from "./lids";
import { drawStrokes, strokesOf } from "./pen-strokes";
import { actorsOf, lookAt, type Scene, sceneOf } from "./scene";

/** Numbers of a pose in a way, and of a thing's place. */
const [POSE, PLACE] = [5, 2];
/** Room around what is driven where nothing else says what is to be seen. */
const AROUND_MM = 200;
const EDGE_PX = 6;
/** Dots of what was driven: so thick, so far apart. */
const [DOT, APART] = [2, 5];
const SELDOM: Seldom = { boards, crowds: null, figures };
/** Of a longer way so many points are drawn. */
const MOST_POINTS = 200;

function numbersAt(way: readonly number[], frame: number, size: number): readonly number[] {
  const from = way.length > size ? frame * size : 0;
  return way.slice(from, from + size);
}

function between(a: number, b: number, share: number): number {
  return a + (b - a) * share;
}

function poseAt(way: readonly number[], moment: number): Pose {
  const frame = Math.floor(moment);
  const [x = 0, y = 0, heading = 0, load = 0, flags = 0] = numbersAt(way, frame, POSE);
  const next = numbersAt(way, frame + 1, POSE);
  const [x2 = x, y2 = y, heading2 = heading] = next;
  const share = moment - frame;
  const turned = (heading2 - heading) / 1000;
  const turn = Math.atan2(Math.sin(turned), Math.cos(turned));
  return {
    x_mm: between(x, x2, share),
    y_mm: between(y, y2, share),
    heading_rad: heading / 1000 + turn * share,
    load,
    flags,
  };
}

function placeAt(way: readonly number[], moment: number): Place {
  const frame = Math.floor(moment);
  const [x = 0, y = 0] = numbersAt(way, frame, PLACE);
  const [x2 = x, y2 = y] = numbersAt(way, frame + 1, PLACE);
  return [between(x, x2, moment - frame), between(y, y2, moment - frame)];
}

/** Where an agent was at each frame up to a moment. */
function driven(way: readonly number[], moment: number): [number, number][] {
  const points: [number, number][] = [];
  if (way.length <= POSE) return points;
  const apart = Math.ceil(way.length / POSE / MOST_POINTS);
  for (let frame = 0; frame <= moment; frame += apart) {
    const [x = 0, y = 0] = numbersAt(way, frame, POSE);
    points.push([x, y]);
  }
  return points;
}

/** The moment that shows most: what was drawn at its end, else a good way through. */
export function bestMoment({ frames, marks }: RunPreview): number {
  return Math.max(0, marks.length > 0 ? frames - 1 : Math.floor((frames - 1) * 0.7));
}

/** What of the world is to be seen. */
export function boxOf(world: World, { ways }: RunPreview): Box {
  const points = ways.flatMap((way) => {
    const found = driven(way, way.length / POSE - 1);
    const [x = 0, y = 0] = way;
    return found.length > 0 ? found : [[x, y] as [number, number]];
  });
  const places = points.map(([x_mm, y_mm]) => ({ x_mm, y_mm }));
  const content = contentOf(world, places);
  // Walls alone say little: what is driven is seen closely.
  const has = world.roads.length + world.lines.length + world.floors.length + world.storehouses.length;
  if (has > 0 || [...(world.things ?? []), ...(world.zones ?? [])].length > 0 || points.length === 0) return content;
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  const around = Math.min(AROUND_MM, world.width_mm / 2);
  return {
    left: Math.min(...xs) - around,
    right: Math.max(...xs) + around,
    bottom: Math.min(...ys) - around,
    top: Math.max(...ys) + around,
  };
}

/** The scene of a preview at a moment, without where anybody is. */
export function sceneAt(preview: RunPreview, world: World, catalogue: Catalogue, moment: number): Scene {
  const shown = preview.agents.map((): Record<string, number[]> => ({}));
  for (const { frame, agent, part, numbers } of preview.shown) {
    const parts = shown[agent];
    if (frame <= moment && parts !== undefined) parts[part] = numbers;
  }
  const stock: Record<string, number> = {};
  for (const { frame, storehouse, boxes } of preview.stock) if (frame <= moment) stock[storehouse] = boxes;
  const agents = preview.agents.map((agent, at) => ({
    ...agent,
    state: "running" as const,
    inputs: {},
    shown: shown[at] ?? {},
  }));
  const actors = actorsOf(agents, preview, catalogue, world);
  return sceneOf({ stock, delivered: {}, total: 0, collisions: 0 }, actors, world);
}

function drawDriven({ pen, camera }: Brush, points: readonly [number, number][], colour: string): void {
  if (points.length < 2) return;
  pen.save();
  pen.beginPath();
  for (const [x, y] of points) pen.lineTo(...toScreen(camera, x, y));
  pen.strokeStyle = colour;
  pen.lineWidth = DOT;
  pen.lineCap = "round";
  pen.setLineDash([0, APART]);
  pen.stroke();
  pen.restore();
}

interface Drawn {
  preview: RunPreview;
  world: World;
  catalogue: Catalogue;
  colours: Colours;
  dark: boolean;
  /** What of the world is seen. */
  box: Box;
  /** Whether robots have their names beside them. */
  names: boolean;
}

/** Draws a preview at a moment on a canvas that is as large as `room`. */
export function drawMoment(
  pen: CanvasRenderingContext2D,
  room: Room,
  { preview, world, catalogue, colours, dark, box, names }: Drawn,
  moment: number,
): void {
  const camera = fitBox(box, room, EDGE_PX);
  const brush: Brush = { pen, camera, room, unit: unitOf(camera, world), colours };
  const scene = sceneAt(preview, world, catalogue, moment);
  const poses = preview.ways.map((way) => poseAt(way, moment));
  const seen = lookAt(scene, poses);
  drawWorld(brush, scene);
  for (const [at, { actor }] of seen.entries()) {
    if (actor.role !== "robot" || actor.face !== null) continue;
    const lid = LIDS[actor.lid];
    const pose = poses[at];
    if (lid === undefined || pose === undefined) continue;
    const points = driven(preview.ways[at] ?? [], moment);
    if (points.length > 0) drawDriven(brush, [...points, [pose.x_mm, pose.y_mm]], dark ? lid.dark : lid.light);
  }
  const marks = preview.marks.flatMap(([frame = 0, pen = 0, what = 0, x = 0, y = 0, colour = 0, width = 1]) =>
    frame <= moment ? [[pen, what as PenMark[1], x, y, colour, width] as PenMark] : [],
  );
  const ends = (pen: number) => {
    const at = poses[preview.pens[pen] ?? -1];
    return at === undefined ? undefined : ([at.x_mm, at.y_mm] as const);
  };
  drawStrokes(brush, strokesOf(marks, ends));
  drawThings(
    brush,
    world,
    preview.things.map((way) => placeAt(way, moment)),
  );
  drawActors(brush, scene, seen, "", "", SELDOM, { place: false, names });
}
