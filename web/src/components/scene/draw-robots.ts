/** Draws who is in the world: figures with their numbers, and rings. What only a run shows of them is the stage's (`features/arena/stage`). */
import { ARM_OUT, LAMP, type Storehouse } from "../../api/wire";
import { grouped } from "../../i18n/numbers";
import { t } from "../../i18n/words";
import { fontOf } from "../../theme";
import { toScreen } from "./camera";
import { isCrowd } from "./crowd-size";
import type * as DrawBoard from "./draw-board";
import type * as DrawCrowd from "./draw-crowd";
import { type Brush, headOf, robotUnit, write } from "./draw-world";
import type * as Figures from "./figures";
import { boundsOf, isIn } from "./geometry";
import { fillWith } from "./ink";
import { LIDS } from "./lids";
import type { Scene, Seen } from "./scene";

/** The ring of who is watched, and the halo of who is too small to be seen, are no smaller than this, in px. */
const LEAST_RING = 13;
/** A robot of fewer px a unit is too small to be seen: a ring says where it is. */
const LEAST_SEEN = 0.3;
/** More than so many are drawn from pictures that were drawn once. */
const MANY = 24;
/** Of more than so many the names are not written. */
const MOST_NAMED = 60;

/** How far the ring around a robot is from its middle, in px. */
export function ringOf({ role }: { role: string }, unit: number): number {
  return Math.max((role === "arm" ? 30 : 37) * unit, LEAST_RING);
}

function line(brush: Brush, width: number, colour: string): void {
  brush.pen.strokeStyle = colour;
  brush.pen.lineWidth = width;
  brush.pen.stroke();
}

export type Boards = typeof DrawBoard;

/** What is drawn seldom, and fetched when it is; null until then. */
export interface Seldom {
  boards: Boards | null;
  crowds: typeof DrawCrowd | null;
  figures: typeof Figures | null;
}

/** How much is said of robots: where the one is that is watched, and the names of all. */
export interface Said {
  place: boolean;
  names: boolean;
}

/** What a robot's figure shows of it. */
export function looksOf({ actor, pose, failed, stalled }: Seen, load = pose.load): Figures.Looks {
  return {
    figure: actor.figure,
    lid: actor.lid,
    load,
    lamp: (pose.flags & LAMP) !== 0,
    face: failed ? "out" : stalled ? "shut" : "open",
    out: (pose.flags & ARM_OUT) !== 0,
  };
}

/** Around a robot that is small on the screen: a dotted ring that is no body, and where it looks. */
function drawHalo(brush: Brush, { actor, pose }: Seen): void {
  const { pen, colours, unit } = brush;
  const ring = ringOf(actor, unit);
  pen.beginPath();
  pen.arc(0, 0, ring, 0, Math.PI * 2);
  pen.setLineDash([2, 3]);
  line(brush, 1.25, colours.muted);
  pen.setLineDash([]);
  const [ux, uy] = [Math.cos(pose.heading_rad), -Math.sin(pose.heading_rad)];
  pen.beginPath();
  pen.moveTo(ux * (ring + 6), uy * (ring + 6));
  pen.lineTo(ux * (ring + 1) - uy * 4, uy * (ring + 1) + ux * 4);
  pen.lineTo(ux * (ring + 1) + uy * 4, uy * (ring + 1) - ux * 4);
  fillWith(pen, colours.ink);
}

/** Under a robot its number on a disc of its colour, and its name where there is room. */
function drawName(brush: Brush, { actor }: Seen, away: number, named: boolean): void {
  const { pen, colours } = brush;
  const y = away + 11;
  pen.textBaseline = "middle";
  pen.font = fontOf(600, 12);
  const width = named ? pen.measureText(actor.name).width : 0;
  const left = named ? -(width + 30) / 2 : -10;
  if (named) {
    pen.beginPath();
    pen.roundRect(left, y - 10, width + 30, 20, 10);
    fillWith(pen, colours.panel);
    line(brush, 1, colours.line2);
    pen.textAlign = "left";
    write(brush, actor.name, left + 22, y + 0.5, 12, 600, colours.text);
  }
  pen.beginPath();
  pen.arc(left + 10, y, 7, 0, Math.PI * 2);
  fillWith(pen, LIDS[actor.lid]?.fill ?? colours.panel);
  line(brush, 1, colours.robotLine);
  pen.textAlign = "center";
  write(
    brush,
    String(actor.number),
    left + 10,
    y + 0.5,
    actor.number > 99 ? 7 : actor.number > 9 ? 9 : 10,
    700,
    "#1b1f27",
  );
}

/** Who sits in a storehouse is drawn in its heading: where, in px, and how large. */
export function keeperPlace(
  brush: Brush,
  scene: Scene,
  { actor }: Seen,
): { house: Storehouse; x: number; y: number; unit: number } | null {
  const house = scene.world.storehouses.find((one) => isIn(one, actor.start));
  if (house === undefined) return null;
  const [right, top] = toScreen(brush.camera, house.x_mm + house.width_mm, house.y_mm + house.height_mm);
  const unit = headOf(brush, house) / 54;
  return { house, x: right - 34 * unit, y: top + 26 * unit, unit };
}

/** Upright, with the count before it. */
function drawKeeper(brush: Brush, scene: Scene, one: Seen, figures: typeof Figures): void {
  const place = keeperPlace(brush, scene, one);
  if (place === null) return;
  const { house, x, y, unit } = place;
  const { pen } = brush;
  pen.save();
  pen.translate(x, y);
  figures.drawFigure(pen, unit, looksOf(one, scene.stock[house.name] ?? house.stock), brush.colours);
  pen.restore();
}

function drawSeen(usual: Brush, one: Seen, selected: boolean, { boards, figures }: Seldom, count: number): void {
  const { actor, pose } = one;
  const board = actor.face === null ? null : boards;
  const real = robotUnit(usual.camera, actor.length_mm);
  const brush = { ...usual, unit: board === null ? real : board.boardUnit(usual.unit, count) };
  const { pen, camera, colours, unit } = brush;
  pen.save();
  pen.translate(...toScreen(camera, pose.x_mm, pose.y_mm));
  pen.save();
  pen.rotate(-pose.heading_rad);
  if (actor.face !== null) board?.drawBoard(brush, one, selected);
  else if (count > MANY) figures?.drawSprite(pen, unit, looksOf(one), colours, window.devicePixelRatio || 1);
  else figures?.drawFigure(pen, unit, looksOf(one), colours);
  pen.restore();
  if (board === null && actor.role === "robot" && unit < LEAST_SEEN) drawHalo(brush, one);
  const away = board === null ? ringOf(actor, unit) : board.boardReach(unit);
  boards?.drawIndicators(brush, actor, away);
  pen.restore();
}

/** Around the one of several that is watched: on the floor, under what is drawn there. */
export function drawRing(usual: Brush, seen: readonly Seen[], selected: string): void {
  const one = seen.length < 2 ? undefined : seen.find(({ actor }) => actor.name === selected);
  if (one === undefined || one.actor.face !== null || one.actor.role === "keeper") return;
  const { pen, camera, colours } = usual;
  const [x, y] = toScreen(camera, one.pose.x_mm, one.pose.y_mm);
  pen.beginPath();
  pen.arc(x, y, ringOf(one.actor, robotUnit(camera, one.actor.length_mm)), 0, Math.PI * 2);
  line(usual, 2, colours.ink);
}

/** What is said of a robot beside it: after everybody was drawn, so that no arm covers it. */
function drawTag(usual: Brush, one: Seen, selected: boolean, { boards }: Seldom, count: number, said: Said): void {
  const { actor, pose } = one;
  // One alone needs no number, and what it draws stays free.
  if (count < 2 || actor.role !== "robot" || actor.indicators.length > 0 || (!selected && count > MOST_NAMED)) return;
  const board = actor.face === null ? null : boards;
  const unit = board === null ? robotUnit(usual.camera, actor.length_mm) : board.boardUnit(usual.unit, count);
  const brush = { ...usual, unit };
  const away = board === null ? ringOf(actor, unit) : board.boardReach(unit);
  brush.pen.save();
  brush.pen.translate(...toScreen(usual.camera, pose.x_mm, pose.y_mm));
  drawName(
    brush,
    one,
    board === null && !(said.names && selected) ? Math.max((said.names ? 30 : 25) * unit, 8) : away,
    said.names,
  );
  brush.pen.restore();
}

/** The middle of the first ring road, where the score stands. */
export function scoreAt(scene: Scene): [x_mm: number, y_mm: number] | null {
  const ring = scene.world.roads.find((road) => road.closed);
  if (ring === undefined) return null;
  const box = boundsOf(ring);
  return [(box.left + box.right) / 2, (box.bottom + box.top) / 2];
}

/** Words of their own on the arena stand on the panel's colour, whatever lies below. */
function drawCaption(
  brush: Brush,
  words: string,
  x: number,
  y: number,
  px: number,
  weight: number,
  colour: string,
): void {
  const { pen, colours } = brush;
  pen.textAlign = "left";
  pen.textBaseline = "middle";
  pen.font = fontOf(weight, px);
  const width = pen.measureText(words).width + 16;
  const left = Math.min(Math.max(x, 8), Math.max(8, brush.room.width - width - 8));
  pen.beginPath();
  pen.roundRect(left, y - px * 0.85, width, px * 1.7, px * 0.85);
  fillWith(pen, colours.panel);
  write(brush, words, left + 8, y + 0.5, px, weight, colour);
}

/** "7 of 12 delivered": in the middle of the ring, else at the top. */
function drawScore(brush: Brush, scene: Scene): void {
  if (scene.total === 0) return;
  const { pen, camera, room, colours, unit } = brush;
  const middle = scoreAt(scene);
  const words = t("arena.of", { done: scene.delivered, total: scene.total });
  if (middle === null) {
    drawCaption(brush, `${words} ${t("arena.delivered")}`, room.width / 2 - 70, 20, 14, 600, colours.text);
    return;
  }
  pen.textAlign = "center";
  pen.textBaseline = "alphabetic";
  const [x, y] = toScreen(camera, ...middle);
  write(brush, words, x, y + 3 * unit, 20 * unit, 700, colours.text);
  write(brush, t("arena.delivered"), x, y + 22 * unit, 13 * unit, 400, colours.muted);
}

/** Where there is no road to see it by: place and direction of the robot that is watched. */
function drawPlace(brush: Brush, scene: Scene, one: Seen): void {
  if (scene.world.roads.length > 0 || one.actor.role !== "robot") return;
  const { room, colours } = brush;
  const angle = Math.round((one.pose.heading_rad * 180) / Math.PI);
  const words = t("arena.pose", {
    name: one.actor.name,
    x: grouped(Math.round(one.pose.x_mm)),
    y: grouped(Math.round(one.pose.y_mm)),
    angle: ((angle % 360) + 360) % 360,
  });
  drawCaption(brush, words, 8, room.height - 16, 12, 500, colours.muted);
}

/** Everybody. `program`: robots of another one step back; "" for none. */
export function drawActors(
  brush: Brush,
  scene: Scene,
  seen: readonly Seen[],
  selected: string,
  program: string,
  seldom: Seldom,
  said: Said,
): void {
  drawScore(brush, scene);
  const { figures, crowds } = seldom;
  const crowd = isCrowd(seen.length, brush.camera.scale);
  if (crowd) crowds?.drawCrowd(brush, seen, program);
  const closely = crowd ? seen.filter((one) => one.actor.name === selected) : seen;
  const { pen } = brush;
  const stands = (one: Seen) => (program === "" || one.actor.program === program ? 1 : 0.3);
  const draw = (role: Seen["actor"]["role"], act: (one: Seen) => void) => {
    for (const one of closely) {
      if (one.actor.role !== role) continue;
      pen.globalAlpha = stands(one);
      act(one);
    }
  };
  if (figures !== null) draw("keeper", (one) => drawKeeper(brush, scene, one, figures));
  for (const role of ["robot", "arm"] as const)
    draw(role, (one) => drawSeen(brush, one, one.actor.name === selected, seldom, closely.length));
  draw("robot", (one) => drawTag(brush, one, one.actor.name === selected, seldom, closely.length, said));
  pen.globalAlpha = 1;
  const watched = seen.find((one) => one.actor.name === selected);
  // A board shows itself; what it senses changes all the time.
  if (watched === undefined || watched.actor.face !== null || !said.place) return;
  drawPlace(brush, scene, watched);
}
