/**
 * Draws a robot that is a board: its lights, its buttons, its pins along the edge, and that it sounds. Fetched when the
 * arena shows one, and with it what a hand does to it.
 *
 * A board is 64 units wide, about as large as a robot is long, but never so small on the screen that its lights cannot be
 * told apart. Its upper edge is up where its heading is 0.
 */
import { type HandKey, type Indicator, lightsOf } from "./boards";
import { toScreen } from "./camera";
import { type Brush, write } from "./draw-world";
import { fillWith, strokeWith } from "./ink";
import type { Actor, Seen } from "./scene";

export { press, release, releaseAll } from "./hands";

const [WIDTH, HEIGHT] = [64, 54];
const EDGE = 9;
const PITCH = 5.8;
const LIGHTS_Y = -4;
const KEY = { radius: 5, reach: 9 };
/** Where the buttons of a board are, in their order: on the left, on the right, and the logo above its lights. */
const KEYS = [
  { x: -24, y: -4, isLogo: false },
  { x: 24, y: -4, isLogo: false },
  { x: 0, y: -22, isLogo: true },
];
const LEAST_PX = 150;
const MANY = 4;

/** Boards have colours of their own, alike in every theme. */
const COLOURS = {
  board: "#1c2530",
  rim: "#3d4a5c",
  plate: "#aab4c0",
  key: "#11161d",
  held: "#ffcf4a",
  gold: "#d2a93a",
  goldDark: "#8d6f1d",
  off: "#46282c",
  on: "255 64 48",
  ink: "#f4f6f8",
  pin: "#9fb0c4",
};

/** Px a unit for boards; few of them are drawn larger than they are. */
export function boardUnit(unit: number, boards: number): number {
  return boards > MANY ? unit : Math.max(unit, LEAST_PX / WIDTH);
}

function box(brush: Brush, x: number, y: number, width: number, height: number, radius: number, fill: string): void {
  const { pen, unit: u } = brush;
  pen.beginPath();
  pen.roundRect(x * u, y * u, width * u, height * u, radius * u);
  fillWith(pen, fill);
}

function disc({ pen, unit: u }: Brush, x: number, y: number, radius: number, fill: string): void {
  pen.beginPath();
  pen.arc(x * u, y * u, radius * u, 0, Math.PI * 2);
  fillWith(pen, fill);
}

function drawLights(brush: Brush, rows: readonly number[]): void {
  rows.forEach((row, line) => {
    lightsOf(row).forEach((light, column) => {
      const [x, y] = [(column - 2) * PITCH, LIGHTS_Y + (line - 2) * PITCH];
      if (light > 0) disc(brush, x, y, 3.6, `rgb(${COLOURS.on} / ${String(4 + 2.5 * light)}%)`);
      box(brush, x - 1.3, y - 1.9, 2.6, 3.8, 0.8, COLOURS.off);
      if (light > 0) box(brush, x - 1.3, y - 1.9, 2.6, 3.8, 0.8, `rgb(${COLOURS.on} / ${String(28 + 8 * light)}%)`);
    });
  });
}

function drawEdge(brush: Brush, pins: readonly number[]): void {
  const top = HEIGHT / 2 - EDGE;
  ["0", "1", "2", "3V", "⏚"].forEach((name, number) => {
    const x = (number - 2) * 12;
    box(brush, x - 4.6, top, 9.2, EDGE, 1.2, COLOURS.gold);
    const level = number < 3 ? (pins[number] ?? 0) : 0;
    disc(brush, x, top + EDGE / 2, 2.9, COLOURS.goldDark);
    disc(brush, x, top + EDGE / 2, 2.2, level > 0 ? `rgb(255 224 120 / ${String(35 + 65 * level)}%)` : COLOURS.key);
    write(brush, name, x * brush.unit, (top - 3) * brush.unit, 4 * brush.unit, 600, COLOURS.pin);
  });
}

/** The buttons on the board itself that have a place there. */
function placedKeys(keys: readonly HandKey[]): { key: HandKey; x: number; y: number; isLogo: boolean }[] {
  const on = keys.filter((key) => key.onBoard);
  return KEYS.flatMap((place, number) => {
    const key = on[number];
    return key === undefined ? [] : [{ key, ...place }];
  });
}

function drawKeys(brush: Brush, { actor }: Seen): void {
  for (const { key, x, y, isLogo } of placedKeys(actor.keys)) {
    if (isLogo) drawLogo(brush, key, x, y);
    else {
      box(brush, x - 6.5, y - 6.5, 13, 13, 1.8, COLOURS.plate);
      disc(brush, x, y, key.pressed ? KEY.radius - 0.7 : KEY.radius, key.pressed ? COLOURS.held : COLOURS.key);
      write(brush, key.letter, x * brush.unit, (y - 10) * brush.unit, 6 * brush.unit, 700, COLOURS.ink);
    }
  }
}

/** A golden oval with two eyes, and its letter beside it. */
function drawLogo(brush: Brush, { letter, pressed }: HandKey, x: number, y: number): void {
  box(brush, x - 6.5, y - 3, 13, 6, 3, pressed ? COLOURS.held : COLOURS.gold);
  box(brush, x - 5, y - 1.6, 10, 3.2, 1.6, COLOURS.board);
  for (const side of [-2.2, 2.2]) disc(brush, x + side, y, 1, pressed ? COLOURS.held : COLOURS.gold);
  write(brush, letter, (x - 11) * brush.unit, y * brush.unit, 6 * brush.unit, 700, COLOURS.ink);
}

/** Waves beside the board while it sounds. */
function drawSound({ pen, unit: u, colours }: Brush): void {
  pen.lineCap = "round";
  pen.strokeStyle = colours.ink;
  pen.lineWidth = 1.6 * u;
  for (const radius of [5, 9, 13]) {
    pen.beginPath();
    pen.arc((WIDTH / 2 + 1) * u, (-HEIGHT / 2 + 6) * u, radius * u, -1.1, 0.5);
    pen.stroke();
  }
  pen.lineCap = "butt";
}

/** The origin is the board's middle, and the brush's unit that of boards. */
export function drawBoard(brush: Brush, one: Seen, selected: boolean): void {
  const { pen, unit: u, colours } = brush;
  const { face } = one.actor;
  if (face === null) return;
  if (selected) {
    pen.beginPath();
    pen.roundRect((-WIDTH / 2 - 3) * u, (-HEIGHT / 2 - 3) * u, (WIDTH + 6) * u, (HEIGHT + 6) * u, 8 * u);
    strokeWith(pen, colours.ink, 2);
  }
  box(brush, -WIDTH / 2, -HEIGHT / 2, WIDTH, HEIGHT, 6, COLOURS.board);
  strokeWith(pen, COLOURS.rim, Math.max(u, 1));
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  drawEdge(brush, face.pins);
  drawLights(brush, face.rows);
  drawKeys(brush, one);
  if (face.sounds) drawSound(brush);
}

/** How far a board reaches below its middle, in px. */
export function boardReach(unit: number): number {
  return (HEIGHT / 2 + 4) * unit;
}

const [ROW, SIGN] = [18, 46];

/** Under a robot, at the origin, a row for each: its name, and its value as lamp, bar, sound or number. */
export function drawIndicators(brush: Brush, { indicators }: Actor, below: number): void {
  const { pen, colours } = brush;
  pen.textBaseline = "middle";
  indicators.forEach((one, row) => {
    const y = below + 12 + row * ROW;
    pen.textAlign = "right";
    write(brush, one.label, -4, y, 11, 500, colours.muted);
    drawValue(brush, one, 4, y);
  });
}

function drawValue({ pen, colours, ...brush }: Brush, { look, value, share }: Indicator, x: number, y: number): void {
  pen.beginPath();
  if (look === "bar") {
    pen.roundRect(x, y - 4, SIGN, 8, 4);
    fillWith(pen, colours.robot);
    strokeWith(pen, colours.muted, 1);
    pen.beginPath();
    pen.roundRect(x, y - 4, Math.max(share * SIGN, share > 0 ? 4 : 0), 8, 4);
    fillWith(pen, colours.ink);
  } else if (look === "lamp") {
    pen.arc(x + 6, y, 5.5, 0, Math.PI * 2);
    fillWith(pen, share > 0 ? `rgb(255 190 40 / ${String(40 + 60 * share)}%)` : colours.robot);
    strokeWith(pen, colours.muted, 1);
  } else if (look === "number") {
    pen.textAlign = "left";
    write({ pen, colours, ...brush }, String(value), x, y, 12, 700, colours.text);
  } else {
    pen.textAlign = "left";
    write({ pen, colours, ...brush }, "♪", x, y, 14, 700, share > 0 ? colours.text : colours.muted);
    pen.strokeStyle = colours.text;
    pen.lineWidth = 1.5;
    for (const radius of share > 0 ? [9, 13] : []) {
      pen.beginPath();
      pen.arc(x + 6, y, radius, -0.7, 0.7);
      pen.stroke();
    }
  }
}

/** The sensor whose button is at a point of the canvas, with its robot. */
export function keyAt(
  brush: Pick<Brush, "camera" | "unit">,
  seen: readonly Seen[],
  x: number,
  y: number,
): { agent: string; sensor: string } | null {
  for (const { actor, pose } of seen) {
    if (actor.face === null) continue;
    const [sx, sy] = toScreen(brush.camera, pose.x_mm, pose.y_mm);
    const [dx, dy] = [(x - sx) / brush.unit, (y - sy) / brush.unit];
    const [cos, sin] = [Math.cos(pose.heading_rad), Math.sin(pose.heading_rad)];
    // Back into the board's own axes.
    const [bx, by] = [dx * cos - dy * sin, dx * sin + dy * cos];
    for (const place of placedKeys(actor.keys)) {
      if (Math.abs(bx - place.x) < KEY.reach && Math.abs(by - place.y) < KEY.reach)
        return { agent: actor.name, sensor: place.key.sensor };
    }
  }
  return null;
}
