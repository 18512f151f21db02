/**
 * Zones of the floor: dashed edge and waves where it is warm, rings and a horn where it is loud, rays and a sun where it is
 * bright, each with its word and value. In high contrast lines alone say it: nothing is tinted.
 */
import { decimal } from "../../i18n/numbers";
import { type Key, t } from "../../i18n/words";
import type { World } from "../../model/types";
import { fontOf, useTheme } from "../../theme";
import { toScreen } from "./camera";
import { type Brush, write } from "./draw-world";
import { fillWith, strokeWith } from "./ink";

export type Zone = NonNullable<World["zones"]>[number];

/** How a zone is drawn, in px around its middle: half its width and height, how round its corners are. */
interface Outline {
  x: number;
  y: number;
  halfWidth: number;
  halfHeight: number;
  round: number;
}

/** Colours of lines on light and on dark ground. */
const LINES: Readonly<Record<Zone["kind"], readonly [light: string, dark: string]>> = {
  warm: ["#c2650f", "#e08a45"],
  loud: ["#7549cc", "#a787f0"],
  bright: ["#946500", "#e5b93f"],
};

/** In a square of 24 px, around its middle. */
const SIGNS: Readonly<Record<Zone["kind"], string>> = {
  warm: "M2-8V2.5a4 4 0 1 1-4 0V-8a2 2 0 0 1 4 0Z",
  loud: "M-1-7.3L-5.8-4H-10V4H-5.8L-1 7.3ZM4-3a5 5 0 0 1 0 6M7.4 6.4a9 9 0 0 0 0-12.7",
  bright:
    "M4 0A4 4 0 1 1-4 0A4 4 0 1 1 4 0M0-10V-8M0 8V10M-7.1-7.1L-5.7-5.7M5.7 5.7L7.1 7.1M-10 0H-8M8 0H10M-5.7 5.7L-7.1 7.1M7.1-7.1L5.7-5.7",
};

const [HALO_STEPS, HALO_ALPHA, FILL_ALPHA] = [9, 0.026, 0.16];
/** A zone that is smaller on the screen has no waves. */
const LEAST_MARKS_PX = 36;
/** Words may be so much wider than their zone; then only the value is said, and then nothing. */
const WIDER = 1.25;
const RAYS = 12;

export function valueOf({ kind, value }: Pick<Zone, "kind" | "value">): string {
  return `${decimal(value)} ${kind === "warm" ? "°C" : "%"}`;
}

function outlineOf({ camera }: Brush, zone: Zone): Outline {
  const [x, y] = toScreen(camera, zone.x_mm, zone.y_mm);
  const round = zone.radius_mm * camera.scale;
  if (round > 0) return { x, y, halfWidth: round, halfHeight: round, round };
  return {
    x,
    y,
    halfWidth: (zone.width_mm * camera.scale) / 2,
    halfHeight: (zone.height_mm * camera.scale) / 2,
    round,
  };
}

/** The outline, so many px larger all round. */
function trace(pen: CanvasRenderingContext2D, { x, y, halfWidth, halfHeight, round }: Outline, more = 0): void {
  const [width, height] = [halfWidth + more, halfHeight + more];
  pen.beginPath();
  pen.roundRect(x - width, y - height, 2 * width, 2 * height, Math.max(round + more, 0));
}

function inner(outline: Outline, part: number): Outline {
  const { halfWidth, halfHeight, round } = outline;
  return { ...outline, halfWidth: halfWidth * part, halfHeight: halfHeight * part, round: round * part };
}

function drawWaves({ pen }: Brush, { x, y, halfWidth, halfHeight }: Outline): void {
  const size = Math.min(halfWidth, halfHeight) * 0.2;
  for (const [across, up] of [
    [-0.42, -0.42],
    [0, -0.6],
    [0.42, -0.42],
    [-0.52, 0.3],
    [0.52, 0.3],
  ] as const) {
    const [left, top] = [x + across * halfWidth, y + up * halfHeight - size / 2];
    for (const beside of [-size * 0.35, size * 0.35]) {
      pen.beginPath();
      pen.moveTo(left + beside, top);
      pen.bezierCurveTo(
        left + beside + size / 2,
        top + size / 3,
        left + beside - size / 2,
        top + (size * 2) / 3,
        left + beside,
        top + size,
      );
      pen.stroke();
    }
  }
}

function drawRays({ pen }: Brush, { x, y, halfWidth, halfHeight }: Outline): void {
  pen.beginPath();
  for (let ray = 0; ray < RAYS; ray++) {
    const turn = (ray / RAYS) * 2 * Math.PI;
    const [across, up] = [Math.cos(turn) * halfWidth, Math.sin(turn) * halfHeight];
    const end = ray % 2 === 0 ? 0.9 : 0.75;
    pen.moveTo(x + across * 0.55, y + up * 0.55);
    pen.lineTo(x + across * end, y + up * end);
  }
  pen.stroke();
}

/** A sign around a place, `size` px wide. */
function drawSign({ pen }: Brush, kind: Zone["kind"], x: number, y: number, size: number, colour: string): void {
  pen.save();
  pen.translate(x, y);
  pen.scale(size / 24, size / 24);
  pen.lineWidth = 2;
  pen.lineCap = "round";
  pen.lineJoin = "round";
  pen.strokeStyle = colour;
  pen.stroke(new Path2D(SIGNS[kind]));
  pen.restore();
}

/** The sign, the word and the value on a pill, as far as there is room. */
function drawWords(brush: Brush, zone: Zone, x: number, y: number, room: number): void {
  const { pen, colours } = brush;
  pen.font = fontOf(600, 13);
  const width = (text: string) => pen.measureText(text).width + 38;
  // Each keeps the way that it is written in.
  const value = `\u2066${valueOf(zone)}\u2069`;
  const words = [`\u2068${t(`world.${zone.kind}` as Key)}\u2069 ${value}`, value].find((text) => width(text) <= room);
  if (words === undefined) return;
  const wide = width(words);
  pen.beginPath();
  pen.roundRect(x - wide / 2, y - 12, wide, 24, 6);
  fillWith(pen, colours.panel);
  strokeWith(pen, colours.line2, 1);
  drawSign(brush, zone.kind, x - wide / 2 + 16, y, 14, colours.text);
  pen.textAlign = "left";
  pen.textBaseline = "middle";
  write(brush, words, x - wide / 2 + 28, y + 0.5, 13, 600, colours.text);
}

function drawZone(brush: Brush, zone: Zone, contrast: boolean, dark: boolean): void {
  const { pen, camera, colours } = brush;
  const outline = outlineOf(brush, zone);
  const falloff = zone.falloff_mm * camera.scale;
  const line = contrast ? colours.ink : LINES[zone.kind][dark ? 1 : 0];
  pen.save();
  if (contrast) {
    if (falloff > 0) {
      trace(pen, outline, falloff);
      pen.setLineDash([2, 6]);
      strokeWith(pen, line, 1);
    }
  } else {
    pen.fillStyle = line;
    pen.globalAlpha = HALO_ALPHA;
    for (let step = 1; step <= HALO_STEPS && falloff > 0; step++) {
      trace(pen, outline, (falloff * step) / HALO_STEPS);
      pen.fill();
    }
    pen.globalAlpha = FILL_ALPHA;
    trace(pen, outline);
    pen.fill();
    pen.globalAlpha = 1;
  }
  pen.strokeStyle = line;
  pen.lineWidth = 2;
  pen.setLineDash(zone.kind === "warm" ? [5, 4] : []);
  trace(pen, outline);
  pen.stroke();
  pen.setLineDash([]);
  const size = 2 * Math.min(outline.halfWidth, outline.halfHeight);
  const own = zone.kind !== "warm";
  if (size >= LEAST_MARKS_PX) {
    pen.lineWidth = 1.5;
    if (zone.kind === "warm") drawWaves(brush, outline);
    else if (zone.kind === "bright") drawRays(brush, outline);
    else {
      for (const part of [0.78, 0.56, 0.34]) {
        trace(pen, inner(outline, part));
        pen.stroke();
      }
    }
    if (own) drawSign(brush, zone.kind, outline.x, outline.y, Math.min(Math.max(size * 0.2, 18), 44), line);
  }
  pen.restore();
  const below = own ? Math.min(Math.max(size * 0.1, 9), 22) + 16 : 0;
  drawWords(brush, zone, outline.x, outline.y + below, 2 * outline.halfWidth * WIDER);
}

/** All zones of the world, one after another. */
export function drawZones(brush: Brush, world: World): void {
  const { theme } = useTheme.getState();
  for (const zone of world.zones ?? []) drawZone(brush, zone, theme === "contrast", theme !== "light");
}
