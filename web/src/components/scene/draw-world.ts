/**
 * Draws the place: ground and grid, walls, roads with kerbs and sections, docks, storehouses with their boxes.
 *
 * Measures in px hold where a robot is 54 px long; `unit` is how many real px one of those is.
 */
import type { DockPose, Road, Storehouse } from "../../api/wire";
import type { World } from "../../model/types";
import { fontOf } from "../../theme";
import { type Camera, type Room, toScreen } from "./camera";
import type { Colours } from "./colours";
import { drawFloor } from "./draw-floor";
import { boundsOf, isIn, lineOf, placeAlong, ROBOT_MM } from "./geometry";
import { fillWith, strokeWith } from "./ink";
import type { Scene } from "./scene";

/** A robot is drawn this long. */
const ROBOT_UNITS = 54;
const LEAST_UNIT = 0.85;
/** The shade of a wall lies so far to the right of it and below, in units. */
const SHADE_UNITS = 2.5;

export interface Brush {
  pen: CanvasRenderingContext2D;
  camera: Camera;
  room: Room;
  unit: number;
  colours: Colours;
}

/** Px a unit for a robot of that length: it is drawn as large as it is, always. */
export function robotUnit(camera: Camera, length_mm: number): number {
  return (camera.scale * length_mm) / ROBOT_UNITS;
}

/** Px a unit for walls, words and boxes: in an open room never so small that they cannot be seen; on a road they fit. */
export function unitOf(camera: Camera, world: World): number {
  const real = robotUnit(camera, ROBOT_MM);
  return world.roads.length > 0 ? real : Math.max(real, LEAST_UNIT);
}

export function write(
  brush: Brush,
  text: string,
  x: number,
  y: number,
  px: number,
  weight: number,
  colour: string,
): void {
  const { pen } = brush;
  pen.font = fontOf(weight, px);
  pen.fillStyle = colour;
  pen.fillText(text, x, y);
}

function trace(brush: Brush, road: Road): void {
  const { pen, camera } = brush;
  pen.beginPath();
  for (const [x, y] of lineOf(road)) pen.lineTo(...toScreen(camera, x, y));
  if (road.closed) pen.closePath();
}

function drawRoad(brush: Brush, road: Road): void {
  const { pen, camera, colours } = brush;
  const width = road.width_mm * camera.scale;
  pen.lineJoin = "round";
  pen.lineCap = road.closed ? "butt" : "round";
  trace(brush, road);
  strokeWith(pen, colours.kerb, (width * 58) / 50);
  strokeWith(pen, colours.road, width);
  pen.strokeStyle = colours.mark;
  pen.lineWidth = Math.max(1.25 * brush.unit, 0.75);
  pen.setLineDash([7 * brush.unit, 8 * brush.unit]);
  pen.stroke();
  pen.setLineDash([]);
  pen.lineCap = "butt";
  pen.lineWidth = Math.max(1.25 * brush.unit, 0.75);
  for (const section of road.sections) {
    const place = placeAlong(road, section.from_mm);
    if (place === null) continue;
    const [x, y] = toScreen(camera, place.x, place.y);
    const [ax, ay] = [(Math.sin(place.heading) * width) / 2, (Math.cos(place.heading) * width) / 2];
    pen.beginPath();
    pen.moveTo(x - ax, y - ay);
    pen.lineTo(x + ax, y + ay);
    pen.stroke();
  }
}

/** The numbers of the sections stand inside a closed road, left of an open one. */
function drawSigns(brush: Brush, road: Road): void {
  const { pen, camera, colours, unit } = brush;
  const box = boundsOf(road);
  const [cx, cy] = [(box.left + box.right) / 2, (box.bottom + box.top) / 2];
  for (const section of road.sections) {
    const place = placeAlong(road, (section.from_mm + section.to_mm) / 2);
    if (place === null) continue;
    let side = 1;
    if (road.closed) {
      const inward = -Math.sin(place.heading) * (cx - place.x) + Math.cos(place.heading) * (cy - place.y);
      side = inward >= 0 ? 1 : -1;
    }
    const away = road.width_mm / 2 + (18 * unit) / camera.scale;
    const [x, y] = toScreen(
      camera,
      place.x - Math.sin(place.heading) * away * side,
      place.y + Math.cos(place.heading) * away * side,
    );
    pen.beginPath();
    pen.arc(x, y, 11.5 * unit, 0, Math.PI * 2);
    fillWith(pen, colours.house);
    strokeWith(pen, colours.line2, 1);
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    write(brush, String(section.sign), x, y + 0.5 * unit, 13 * unit, 600, colours.text);
  }
}

function drawDock(brush: Brush, dock: DockPose, world: World): void {
  const { pen, camera, colours, unit } = brush;
  const road = world.roads.find((one) => one.name === dock.road);
  if (road === undefined) return;
  const [x, y] = toScreen(camera, dock.x_mm, dock.y_mm);
  const length = Math.max(2 * dock.reach_mm * camera.scale, 66 * unit);
  const width = road.width_mm * camera.scale * 0.84;
  pen.save();
  pen.translate(x, y);
  pen.rotate(-dock.heading_rad);
  pen.beginPath();
  pen.roundRect(-length / 2, -width / 2, length, width, 4 * unit);
  fillWith(pen, colours.bay);
  strokeWith(pen, colours.bayLine, 2 * unit);
  pen.restore();
}

/** One box of stock, `size` px wide, its upper left corner at x, y. */
export function drawBox({ pen, colours }: Brush, x: number, y: number, size: number): void {
  pen.beginPath();
  pen.roundRect(x, y, size, size, size / 9);
  fillWith(pen, colours.box);
  strokeWith(pen, colours.boxLine, Math.max(size / 18, 0.5));
  pen.beginPath();
  pen.moveTo(x + size / 2, y);
  pen.lineTo(x + size / 2, y + size * 0.42);
  pen.lineWidth = size / 7;
  pen.stroke();
}

/** How high the heading of a storehouse is, in px. */
export function headOf({ camera, unit }: Brush, house: Storehouse): number {
  return Math.min(32 * unit, (house.height_mm * camera.scale) / 3);
}

/** `kept`: whether somebody sits in it, who shows the stock. */
function drawHouse(brush: Brush, house: Storehouse, stock: number, caption: string, kept: boolean): void {
  const { pen, camera, colours, unit } = brush;
  const [x, y] = toScreen(camera, house.x_mm, house.y_mm + house.height_mm);
  const [width, height] = [house.width_mm * camera.scale, house.height_mm * camera.scale];
  const head = headOf(brush, house);
  pen.beginPath();
  pen.roundRect(x, y, width, height, 6 * unit);
  fillWith(pen, colours.house);
  strokeWith(pen, colours.line2, Math.max(1.25 * unit, 0.75));
  pen.beginPath();
  pen.moveTo(x, y + head);
  pen.lineTo(x + width, y + head);
  pen.stroke();
  pen.textBaseline = "middle";
  pen.textAlign = "left";
  write(brush, house.name, x + 12 * unit, y + head / 2, 15 * unit, 700, colours.text);
  if (!kept) {
    pen.textAlign = "right";
    write(brush, String(stock), x + width - 12 * unit, y + head / 2, 14 * unit, 500, colours.muted);
  }

  const inner = 7 * unit;
  const usable = { width: width - 2 * inner, height: height - head - 2 * inner };
  let pitch = 19.5 * unit;
  const columnsAt = (size: number) => Math.max(Math.floor(usable.width / size), 1);
  const rows = (size: number) => Math.ceil(Math.max(house.capacity, stock) / columnsAt(size));
  while (rows(pitch) * pitch > usable.height && pitch > 3) pitch *= 0.92;
  const columns = columnsAt(pitch);
  const left = x + (width - columns * pitch) / 2;
  const size = pitch * 0.93;
  for (let slot = 0; slot < Math.max(house.capacity, stock); slot++) {
    const sx = left + (slot % columns) * pitch + (pitch - size) / 2;
    const sy = y + height - inner - (Math.floor(slot / columns) + 1) * pitch + (pitch - size) / 2;
    if (slot < stock) {
      drawBox(brush, sx, sy, size);
    } else {
      pen.beginPath();
      pen.roundRect(sx + 0.5, sy + 0.5, size - 1, size - 1, size / 9);
      pen.setLineDash([1.5 * unit, 1.5 * unit]);
      strokeWith(pen, colours.slot, 1);
      pen.setLineDash([]);
    }
  }
  if (caption === "") return;
  pen.textAlign = "center";
  pen.textBaseline = "alphabetic";
  write(brush, caption, x + width / 2, y + height + 18 * unit, 12.5 * unit, 500, colours.muted);
}

/** The arm that works for a storehouse: the one nearest to its dock. */
function armOf(scene: Scene, house: Storehouse): string {
  const dock = scene.world.docks.find((one) => one.storehouse === house.name);
  if (dock === undefined) return "";
  const far = (one: { start: { x_mm: number; y_mm: number } }) =>
    Math.hypot(one.start.x_mm - dock.x_mm, one.start.y_mm - dock.y_mm);
  const arms = scene.actors.filter((actor) => actor.role === "arm").sort((a, b) => far(a) - far(b));
  return arms[0] !== undefined && far(arms[0]) < 400 ? arms[0].name : "";
}

function drawWalls({ pen, camera, colours, unit }: Brush, world: World): void {
  if (world.walls.length === 0) return;
  const trace = (off: number) => {
    pen.beginPath();
    for (const wall of world.walls) {
      const [[x1, y1], [x2, y2]] = [toScreen(camera, wall.x1, wall.y1), toScreen(camera, wall.x2, wall.y2)];
      pen.moveTo(x1 + off, y1 + off);
      pen.lineTo(x2 + off, y2 + off);
    }
  };
  pen.lineCap = "round";
  pen.lineWidth = Math.max(4 * unit, 3);
  pen.strokeStyle = colours.shade;
  trace(SHADE_UNITS * unit);
  pen.stroke();
  pen.strokeStyle = colours.road;
  trace(0);
  pen.stroke();
}

export function drawWorld(brush: Brush, scene: Scene): void {
  const { world } = scene;
  drawFloor(brush, world);
  for (const road of world.roads) drawRoad(brush, road);
  for (const dock of world.docks) drawDock(brush, dock, world);
  for (const road of world.roads) drawSigns(brush, road);
  drawWalls(brush, world);
  for (const house of world.storehouses) {
    const kept = scene.actors.some(({ role, start }) => role === "keeper" && isIn(house, start));
    drawHouse(brush, house, scene.stock[house.name] ?? house.stock, armOf(scene, house), kept);
  }
}
