/**
 * Draws the floor: large tiles by turns in two tones with a fine grid on them, coloured parts, lines.
 *
 * The tones are so near to each other that trails, pens and words stand out on both.
 */
import type { World } from "../../model/types";
import { type Camera, type Room, toScreen } from "./camera";
import type { Colours } from "./colours";
import { fillWith, strokeWith } from "./ink";

interface FloorBrush {
  pen: CanvasRenderingContext2D;
  camera: Camera;
  room: Room;
  colours: Colours;
}

const GRID_MM = 100;
/** Lines of the grid are at least so far apart, in px. */
const LEAST_GAP = 24;
/** So many gaps of the grid are a tile. */
const TILE_GAPS = 4;
/** Floors are a little paler than lines of the same colour. */
const FLOOR_ALPHA = 0.8;

/** Every other tile, over the whole of the room: the left upper corner of the world is one of a tile. */
function drawTiles({ pen, room, colours }: FloorBrush, left: number, top: number, size: number): void {
  pen.beginPath();
  const [first, row0] = [-Math.ceil(left / size), -Math.ceil(top / size)];
  for (let row = row0; top + row * size < room.height; row++) {
    for (let column = first; left + column * size < room.width; column++) {
      if ((row + column) % 2 === 0) continue;
      const [x, y] = [Math.round(left + column * size), Math.round(top + row * size)];
      const [right, bottom] = [Math.round(left + (column + 1) * size), Math.round(top + (row + 1) * size)];
      pen.rect(x, y, right - x, bottom - y);
    }
  }
  fillWith(pen, colours.tile);
}

function drawGround(brush: FloorBrush, world: World): void {
  const { pen, camera, room, colours } = brush;
  pen.fillStyle = colours.ground;
  pen.fillRect(0, 0, room.width, room.height);
  let step = GRID_MM;
  while (step * camera.scale < LEAST_GAP) step *= 2;
  const [left, top] = toScreen(camera, 0, world.height_mm);
  const gap = step * camera.scale;
  drawTiles(brush, left, top, TILE_GAPS * gap);
  pen.strokeStyle = colours.grid;
  pen.lineWidth = 1;
  pen.beginPath();
  for (let x = left % gap; x < room.width; x += gap) {
    pen.moveTo(Math.round(x) + 0.5, 0);
    pen.lineTo(Math.round(x) + 0.5, room.height);
  }
  for (let y = top % gap; y < room.height; y += gap) {
    pen.moveTo(0, Math.round(y) + 0.5);
    pen.lineTo(room.width, Math.round(y) + 0.5);
  }
  pen.stroke();
}

function drawColours({ pen, camera, colours }: FloorBrush, world: World): void {
  pen.save();
  pen.globalAlpha = FLOOR_ALPHA;
  for (const floor of world.floors) {
    pen.beginPath();
    for (const [x, y] of floor.points) pen.lineTo(...toScreen(camera, x, y));
    pen.fillStyle = colours[floor.colour];
    pen.fill("evenodd");
  }
  pen.restore();
}

/** Coloured lines on the floor, the last one on top as the robots see it. */
function drawLines({ pen, camera, colours }: FloorBrush, world: World): void {
  pen.lineJoin = "round";
  pen.lineCap = "butt";
  for (const line of world.lines) {
    pen.beginPath();
    for (const [x, y] of line.points) pen.lineTo(...toScreen(camera, x, y));
    if (line.closed) pen.closePath();
    strokeWith(pen, colours[line.colour], line.width_mm * camera.scale);
  }
}

export function drawFloor(brush: FloorBrush, world: World): void {
  drawGround(brush, world);
  drawColours(brush, world);
  drawLines(brush, world);
}
