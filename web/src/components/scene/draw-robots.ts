/** Draws who is in the world: robots with lamps, number, bed and load; arms at docks; rings, crosses and the tag. */
import { t } from "../../i18n/words";
import { ARM_OUT, LAMP } from "../../api/wire";
import { grouped } from "../../i18n/numbers";
import { toScreen } from "./camera";
import type * as DrawBoard from "./draw-board";
import type * as DrawCrowd from "./draw-crowd";
import { isCrowd } from "./crowd-size";
import { drawFailed, drawMuted, drawStalled } from "./draw-signs";
import { type Brush, drawBox, robotUnit, write } from "./draw-world";
import { boundsOf } from "./geometry";
import type { Scene, Seen } from "./scene";
import { type Area, placeTag } from "./tag-place";

const MOST_SENSES = 3;
/** The ring of who is watched, and the halo of who is too small to be seen, are no smaller than this, in px. */
const LEAST_RING = 13;
/** A number of fewer px is not written on a robot, but beside it. */
const LEAST_LETTERS = 7;
/** Signs of failures are no smaller than on a robot of so many px a unit. */
const LEAST_SIGN = 0.4;

/** How far the ring around a robot is from its middle, in px. */
export function ringOf({ role }: { role: string }, unit: number): number {
  return Math.max((role === "arm" ? 17 : 34) * unit, LEAST_RING);
}

function line(brush: Brush, width: number, colour: string): void {
  brush.pen.strokeStyle = colour;
  brush.pen.lineWidth = width;
  brush.pen.stroke();
}

/** In the robot's own axes: x forward, y to the left hand, in px; the canvas' y goes down, hence the minus signs. */
function drawBody(brush: Brush, { pose, actor }: Seen): void {
  const { pen, colours, unit: u } = brush;
  pen.fillStyle = colours.wheel;
  for (const x of [-16, 10]) {
    for (const y of [-21.5, 16.5]) {
      pen.beginPath();
      pen.roundRect(x * u, y * u, 10 * u, 5 * u, 1.5 * u);
      pen.fill();
    }
  }
  if ((pose.flags & LAMP) !== 0) {
    const light = pen.createRadialGradient(20 * u, 0, 6 * u, 20 * u, 0, 44 * u);
    light.addColorStop(0, colours.glow);
    light.addColorStop(1, "rgb(255 205 70 / 0%)");
    pen.fillStyle = light;
    pen.beginPath();
    pen.moveTo(24 * u, -14 * u);
    pen.arc(20 * u, 0, 44 * u, -0.62, 0.62);
    pen.lineTo(24 * u, 14 * u);
    pen.fill();
  }
  pen.beginPath();
  // Who moves freely is a disc for walls and others: the corners stay inside.
  pen.roundRect(-27 * u, -19 * u, 54 * u, 38 * u, (actor.free ? 14 : 7) * u);
  pen.fillStyle = colours.robot;
  pen.fill();
  line(brush, Math.max(2 * u, 1), colours.robotLine);
  pen.beginPath();
  pen.roundRect(-22 * u, -14 * u, 24 * u, 28 * u, 3 * u);
  pen.fillStyle = colours.bed;
  pen.fill();
  if (pose.load > 0) drawLoad(brush, pose.load);
  for (const y of [-11, 11]) {
    pen.beginPath();
    pen.arc(22 * u, y * u, 2.4 * u, 0, Math.PI * 2);
    pen.fillStyle = (pose.flags & LAMP) !== 0 ? "#ffcf4a" : colours.robotLine;
    pen.fill();
    if ((pose.flags & LAMP) !== 0) line(brush, u, colours.robotLine);
  }
  const letters = (actor.number > 99 ? 10 : 13) * u;
  if (letters < LEAST_LETTERS) return;
  pen.save();
  pen.translate(12.5 * u, 0);
  pen.rotate(pose.heading_rad);
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  // White bodies in both themes: the number is always dark.
  write(brush, String(actor.number), 0, 0.5 * u, letters, 700, "#1b1f27");
  pen.restore();
}

function drawLoad(brush: Brush, load: number): void {
  const { unit: u } = brush;
  drawBox(brush, -19 * u, -9 * u, 18 * u);
  if (load < 2) return;
  brush.pen.textAlign = "center";
  brush.pen.textBaseline = "middle";
  write(brush, String(load), -10 * u, 2 * u, 11 * u, 700, "#1b1f27");
}

/** An arm: a foot, a link that lies along the road or reaches over it, a gripper. */
function drawArm(brush: Brush, { pose }: Seen): void {
  const { pen, colours, unit: u } = brush;
  const out = (pose.flags & ARM_OUT) !== 0;
  pen.save();
  if (!out) pen.rotate(-Math.PI / 2);
  const reach = (out ? 30 : 24) * u;
  pen.lineCap = "round";
  pen.beginPath();
  pen.moveTo(0, 0);
  pen.lineTo(reach, 0);
  line(brush, 7 * u, colours.robotLine);
  line(brush, 3.5 * u, colours.robot);
  pen.beginPath();
  pen.moveTo(reach + 7 * u, -7 * u);
  pen.lineTo(reach, -7 * u);
  pen.lineTo(reach, 7 * u);
  pen.lineTo(reach + 7 * u, 7 * u);
  line(brush, 2.5 * u, colours.robotLine);
  pen.lineCap = "butt";
  pen.restore();
  pen.beginPath();
  pen.arc(0, 0, 10 * u, 0, Math.PI * 2);
  pen.fillStyle = colours.robot;
  pen.fill();
  line(brush, 2 * u, colours.robotLine);
  pen.beginPath();
  pen.arc(0, 0, 4 * u, 0, Math.PI * 2);
  pen.fillStyle = colours.robotLine;
  pen.fill();
}

/** What the collision sensor feels: waves before the bumper. */
function drawBump({ pen, colours, unit: u }: Brush): void {
  pen.lineCap = "round";
  pen.beginPath();
  for (const reach of [14, 20]) {
    pen.moveTo(20 * u + reach * Math.cos(0.7) * u, -reach * Math.sin(0.7) * u);
    pen.arc(20 * u, 0, reach * u, -0.7, 0.7);
  }
  pen.strokeStyle = colours.ink;
  pen.lineWidth = 1.75 * u;
  pen.stroke();
  pen.lineCap = "butt";
}

export type Boards = typeof DrawBoard;

/** What is drawn seldom, and fetched when it is; null until then. */
export interface Seldom {
  boards: Boards | null;
  crowds: typeof DrawCrowd | null;
}

/** Around a robot that is small on the screen: a dotted ring that is no body, where it looks, and its number. */
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
  pen.fillStyle = colours.ink;
  pen.fill();
  pen.textAlign = "left";
  pen.textBaseline = "alphabetic";
  write(brush, String(actor.number), ring * 0.8, -ring * 0.6, 11, 600, colours.text);
}

function drawSeen(usual: Brush, one: Seen, selected: boolean, boards: Boards | null, count: number): void {
  if (one.actor.role === "keeper") return;
  const board = one.actor.face === null ? null : boards;
  const real = robotUnit(usual.camera, one.actor.length_mm);
  const brush = { ...usual, unit: board === null ? real : board.boardUnit(usual.unit, count) };
  const { pen, camera, colours, unit } = brush;
  const [x, y] = toScreen(camera, one.pose.x_mm, one.pose.y_mm);
  pen.save();
  pen.translate(x, y);
  pen.rotate(-one.pose.heading_rad);
  if (one.actor.face !== null) board?.drawBoard(brush, one, selected);
  else if (one.actor.role === "arm") drawArm(brush, one);
  else drawBody(brush, one);
  if (one.collided) drawBump(brush);
  pen.restore();
  pen.save();
  pen.translate(x, y);
  const sign = { ...brush, unit: Math.max(unit, LEAST_SIGN) };
  if (one.failed) drawFailed(sign);
  else if (one.stalled) drawStalled(sign);
  if (one.muted) drawMuted(sign);
  if (board === null && one.actor.role === "robot" && 13 * unit < LEAST_LETTERS) drawHalo(brush, one);
  boards?.drawIndicators(brush, one.actor, board === null ? ringOf(one.actor, unit) : board.boardReach(unit));
  if (selected && one.actor.face === null) {
    pen.beginPath();
    pen.arc(0, 0, ringOf(one.actor, unit), 0, Math.PI * 2);
    pen.strokeStyle = colours.ink;
    pen.lineWidth = 2;
    pen.stroke();
  }
  pen.restore();
}

/** What the tag should not cover: storehouses, the score, the other robots. */
function takenAreas(brush: Brush, scene: Scene, seen: readonly Seen[], own: Seen): Area[] {
  const { camera, unit: u } = brush;
  const houses = scene.world.storehouses.map((house) => {
    const [left, top] = toScreen(camera, house.x_mm, house.y_mm + house.height_mm);
    return { left, top, width: house.width_mm * camera.scale, height: house.height_mm * camera.scale };
  });
  const around = (x_mm: number, y_mm: number, halfWidth: number, halfHeight: number): Area => {
    const [x, y] = toScreen(camera, x_mm, y_mm);
    return { left: x - halfWidth, top: y - halfHeight, width: 2 * halfWidth, height: 2 * halfHeight };
  };
  const others = seen
    .filter((one) => one !== own && one.actor.role !== "keeper")
    .map((one) => {
      const ring = ringOf(one.actor, robotUnit(camera, one.actor.length_mm));
      return around(one.pose.x_mm, one.pose.y_mm, ring, ring);
    });
  const middle = scoreAt(scene);
  const [left, top] = toScreen(camera, own.pose.x_mm, own.pose.y_mm);
  const shown = own.actor.indicators.map((_, row) => {
    const away = ringOf(own.actor, robotUnit(camera, own.actor.length_mm));
    return { left: left - 60, top: top + away + 18 * row, width: 120, height: 18 };
  });
  return [...houses, ...others, ...shown, ...(middle === null ? [] : [around(middle[0], middle[1], 55 * u, 28 * u)])];
}

/** The tag beside the robot that is watched: its number and what it senses. */
function drawTag(brush: Brush, scene: Scene, seen: readonly Seen[], one: Seen): void {
  const { pen, camera, room, colours } = brush;
  const { senses, number, role, name } = one.actor;
  if (senses.length === 0 || role === "keeper") return;
  const words = [role === "robot" ? String(number) : name, ...senses.slice(0, MOST_SENSES)].join(" · ");
  const [x, y] = toScreen(camera, one.pose.x_mm, one.pose.y_mm);
  pen.font = `600 13px "Inter Variable", system-ui, sans-serif`;
  const size = { width: pen.measureText(words).width + 24, height: 24 };
  const away = ringOf(one.actor, robotUnit(camera, one.actor.length_mm));
  const { area, right, below } = placeTag(x, y, away, size, room, takenAreas(brush, scene, seen, one));
  const middle = area.top + area.height / 2;
  pen.beginPath();
  pen.moveTo(x + right * away * 0.72, y + below * away * 0.72);
  pen.lineTo(x + right * (away * 0.72 + 10), middle);
  pen.lineTo(right > 0 ? area.left : area.left + area.width, middle);
  line(brush, 1.5, colours.ink);
  pen.beginPath();
  pen.roundRect(area.left, area.top, area.width, area.height, 6);
  pen.fillStyle = colours.ink;
  pen.fill();
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  write(brush, words, area.left + area.width / 2, middle + 0.5, 13, 600, colours.onInk);
}

/** The middle of the first ring road, where the score stands. */
function scoreAt(scene: Scene): [x_mm: number, y_mm: number] | null {
  const ring = scene.world.roads.find((road) => road.closed);
  if (ring === undefined) return null;
  const box = boundsOf(ring);
  return [(box.left + box.right) / 2, (box.bottom + box.top) / 2];
}

/** "7 of 12 delivered": in the middle of the ring, else at the top. */
function drawScore(brush: Brush, scene: Scene): void {
  if (scene.total === 0) return;
  const { pen, camera, room, colours, unit } = brush;
  const middle = scoreAt(scene);
  const words = t("arena.of", { done: scene.delivered, total: scene.total });
  pen.textAlign = "center";
  pen.textBaseline = "alphabetic";
  if (middle === null) {
    write(brush, `${words} ${t("arena.delivered")}`, room.width / 2, 24, 14, 600, colours.text);
    return;
  }
  const [x, y] = toScreen(camera, ...middle);
  write(brush, words, x, y + 3 * unit, 20 * unit, 700, colours.text);
  write(brush, t("arena.delivered"), x, y + 22 * unit, 13 * unit, 400, colours.muted);
}

/** Where there is no road to see it by: place and direction of the robot that is watched. */
function drawPlace(brush: Brush, scene: Scene, one: Seen): void {
  if (scene.world.roads.length > 0 || one.actor.role !== "robot") return;
  const { pen, camera, room, colours } = brush;
  const angle = Math.round((one.pose.heading_rad * 180) / Math.PI);
  pen.textAlign = "left";
  pen.textBaseline = "alphabetic";
  const words = t("arena.pose", {
    name: one.actor.name,
    x: grouped(Math.round(one.pose.x_mm)),
    y: grouped(Math.round(one.pose.y_mm)),
    angle: ((angle % 360) + 360) % 360,
  });
  write(brush, words, Math.max(toScreen(camera, 0, 0)[0], 8), room.height - 8, 12, 500, colours.muted);
}

/** Everybody. `program`: robots of another one step back; "" for none. */
export function drawActors(
  brush: Brush,
  scene: Scene,
  seen: readonly Seen[],
  selected: string,
  program: string,
  { boards, crowds }: Seldom,
): void {
  drawScore(brush, scene);
  const crowd = isCrowd(seen.length, brush.camera.scale);
  if (crowd) crowds?.drawCrowd(brush, seen, program);
  const order = { keeper: 0, robot: 1, arm: 2 };
  const closely = crowd ? seen.filter((one) => one.actor.name === selected) : [...seen];
  for (const one of closely.sort((a, b) => order[a.actor.role] - order[b.actor.role])) {
    brush.pen.globalAlpha = program === "" || one.actor.program === program ? 1 : 0.3;
    drawSeen(brush, one, one.actor.name === selected, boards, closely.length);
  }
  brush.pen.globalAlpha = 1;
  const watched = seen.find((one) => one.actor.name === selected);
  // A board shows itself; what it senses changes all the time.
  if (watched === undefined || watched.actor.face !== null) return;
  drawTag(brush, scene, seen, watched);
  drawPlace(brush, scene, watched);
}
