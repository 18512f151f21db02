/**
 * Robots as they are drawn: bodies with faces, one for each kind of figure that a robot's XML may name.
 *
 * Measures are units of 2.5 mm: a robot of 135 mm is 54 units long, x goes ahead, y to the right hand. Outlines are 2 units
 * and never thinner than 1.15 px. Small figures lose what cannot be seen: seams and treads first, then rays of a lamp.
 * Where a figure stands on the screen, and its badges, is left to `draw-robots.ts`; boards have `draw-board.ts`.
 */
import { fontOf } from "../../theme";
import { fillWith, strokeWith } from "./ink";
import { LIDS } from "./lids";

/** What of a robot's state its figure shows. */
export interface Looks {
  figure: string;
  /** Which of `LIDS`. */
  lid: number;
  /** Boxes on its bed. */
  load: number;
  lamp: boolean;
  face: "open" | "shut" | "out";
  /** Of an arm: whether it reaches over the road. */
  out: boolean;
}

/** Colours that change with the theme. */
export interface FigureColours {
  robotLine: string;
  wheel: string;
  bed: string;
  box: string;
  boxLine: string;
}

/** Under so many px a unit seams and treads are left out; under the second, rays. */
const [SEAMS, RAYS] = [0.7, 0.55];
const LEAST_LINE_PX = 1.15;
const [TREAD, LIT, SCREEN] = ["#5b6472", "#ffcf4a", "#1c2530"];

/** The eyes, lamp and wheels of each figure: [x, y, radius], mirrored where y is not 0; wheels [x, y, width, height]. */
interface Parts {
  eye?: readonly [number, number, number];
  lamp?: readonly [number, number, number];
  wheel?: readonly [number, number, number, number];
}

const PARTS: Readonly<Record<string, Parts>> = {
  "mini-robot": { eye: [18, 9.6, 7.4], lamp: [-13.5, 0, 7], wheel: [-9, 17, 20, 6.5] },
  carrier: { eye: [15, 7.8, 6.6], lamp: [22, 13.4, 2.3], wheel: [-17, 17.2, 16, 5.2] },
  "line-follower": { eye: [21, 12.4, 6.9], lamp: [-13, 0, 5.4], wheel: [-21, 16, 19, 6.5] },
  "kit-rover": { eye: [21, 8.4, 7], lamp: [14.5, 12.4, 1.5] },
  loader: { eye: [-3.4, 0, 8] },
  unloader: { eye: [-3.4, 0, 8] },
};

const BODIES: Readonly<Record<string, string>> = {
  "mini-robot": "M-15-19H5A19 19 0 0 1 5 19H-15A12 12 0 0 1-27 7V-7A12 12 0 0 1-15-19Z",
  carrier: "M4-19H13A14 14 0 0 1 27-5V5A14 14 0 0 1 13 19H4A3 3 0 0 1 1 16V-16A3 3 0 0 1 4-19Z",
  "line-follower": "M-19-18H-6L13-9Q19-6 19 0Q19 6 13 9L-6 18H-19A6 6 0 0 1-25 12V-12A6 6 0 0 1-19-18Z",
  "kit-rover": "M-24-16H15A5 5 0 0 1 20-11V11A5 5 0 0 1 15 16H-24A3 3 0 0 1-27 13V-13A3 3 0 0 1-24-16Z",
};
const BED = "M-23-19H3V19H-23A4 4 0 0 1-27 15V-15A4 4 0 0 1-23-19Z";
const MANAGER = "M-18-19H18A6 6 0 0 1 24-13V19A6 6 0 0 1 18 25H-18A6 6 0 0 1-24 19V-13A6 6 0 0 1-18-19Z";
const CLAW = "M27-10.5Q26.5-13.5 22-12.5Q13-10 13 0Q13 10 22 12.5Q26.5 13.5 27 10.5";
const FORK = "M27-9.5H14.5V9.5H27";

const paths = new Map<string, Path2D>();

function pathOf(words: string): Path2D {
  let path = paths.get(words);
  if (path === undefined) {
    path = new Path2D(words);
    paths.set(words, path);
  }
  return path;
}

/** Draws in units: px a unit `u` says how thin a line may be. */
class Hand {
  readonly pen: CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;
  readonly u: number;
  readonly ink: string;

  constructor(pen: Hand["pen"], u: number, ink: string) {
    this.pen = pen;
    this.u = u;
    this.ink = ink;
  }

  path(words: string, fill: string, stroke = this.ink, width = 2, alpha = 1): void {
    const { pen } = this;
    const path = pathOf(words);
    const before = pen.globalAlpha;
    pen.globalAlpha = before * alpha;
    if (fill !== "") {
      pen.fillStyle = fill;
      pen.fill(path);
    }
    if (width > 0) {
      pen.strokeStyle = stroke;
      pen.lineWidth = Math.max(width, LEAST_LINE_PX / this.u);
      pen.stroke(path);
    }
    pen.globalAlpha = before;
  }

  disc(x: number, y: number, r: number, fill: string, width = 2): void {
    const { pen } = this;
    pen.beginPath();
    pen.arc(x, y, r, 0, Math.PI * 2);
    fillWith(pen, fill);
    if (width === 0) return;
    strokeWith(pen, this.ink, Math.max(width, LEAST_LINE_PX / this.u));
  }

  box(x: number, y: number, width: number, height: number, radius: number, fill: string, line = 0): void {
    const { pen } = this;
    pen.beginPath();
    pen.roundRect(x, y, width, height, radius);
    if (fill !== "") {
      fillWith(pen, fill);
    }
    if (line === 0) return;
    strokeWith(pen, this.ink, Math.max(line, LEAST_LINE_PX / this.u));
  }
}

type Place = readonly [x: number, y: number, r: number];

/** One eye, looking ahead: open, shut when its robot stalled, crossed out when it failed. `iris`: a colour, or "". */
function eye(hand: Hand, [x, y, r]: Place, face: Looks["face"], white: string, iris: string, down = false): void {
  hand.disc(x, y, r, face === "shut" ? "#dfe4ea" : white);
  const { pen } = hand;
  pen.lineCap = "round";
  if (face === "shut") {
    hand.path(
      `M${String(x - r * 0.1)} ${String(y - r * 0.75)}q${String(r * 0.7)} ${String(r * 0.75)} 0 ${String(r * 1.5)}`,
      "",
    );
  } else if (face === "out") {
    const a = r * 0.45;
    hand.path(
      `M${String(x - a)} ${String(y - a)}l${String(2 * a)} ${String(2 * a)}m0 ${String(-2 * a)}l${String(-2 * a)} ${String(2 * a)}`,
      "",
    );
  } else {
    const [px, py] = down ? [x, y + 0.24 * r] : [x + 0.26 * r, y];
    if (iris !== "") hand.disc(px, py, 0.64 * r, iris, 0);
    hand.disc(px, py, (iris === "" ? 0.52 : 0.38) * r, hand.ink, 0);
    hand.disc(px + 0.18 * r, py - 0.2 * r, 0.18 * r, "#fff", 0);
  }
  pen.lineCap = "butt";
}

/** A pair of places, one on each side; one where it is in the middle. */
function mirrored([x, y, r]: Place): Place[] {
  return y === 0 ? [[x, y, r]] : [[x, -y, r], [x, y, r]]; // prettier-ignore
}

function wheels(hand: Hand, [x, y, width, height]: readonly [number, number, number, number], fill: string): void {
  for (const top of [-y - height, y]) {
    hand.box(x, top, width, height, 2, fill);
    if (hand.u < SEAMS) continue;
    for (const share of [0.25, 0.5, 0.75])
      hand.path(`M${String(x + width * share)} ${String(top + 1)}v${String(height - 2)}`, "", TREAD, 1.3);
  }
}

function box(hand: Hand, x: number, y: number, size: number, { box: fill, boxLine }: FigureColours): void {
  hand.box(x, y, size, size, size / 9, fill);
  const edge = `M${String(x)} ${String(y)}h${String(size)}v${String(size)}h${String(-size)}Z`;
  hand.path(edge, "", boxLine, size / 18);
  hand.path(`M${String(x + size / 2)} ${String(y)}v${String(size * 0.42)}`, "", boxLine, size / 7);
}

function lampAt(hand: Hand, place: Place, lit: boolean): void {
  const [x, y, r] = place;
  hand.disc(x, y, r, lit ? LIT : "#fff", r > 4 ? 1.7 : 1.1);
  if (!lit || r < 4 || hand.u < RAYS) return;
  let rays = "";
  for (let turn = 0; turn < 8; turn++) {
    const [ux, uy] = [Math.cos((turn * Math.PI) / 4), Math.sin((turn * Math.PI) / 4)];
    rays += `M${String(x + ux * r * 0.45)} ${String(y + uy * r * 0.45)}L${String(x + ux * r * 0.75)} ${String(y + uy * r * 0.75)}`;
  }
  hand.path(rays, "", hand.ink, 1.1);
}

/** The light around a robot whose lamp is on; drawn under all bodies. */
export function drawGlow(pen: CanvasRenderingContext2D, figure: string, u: number, glow: string): void {
  const x = (PARTS[figure]?.lamp?.[0] ?? 0) * u * 0.5;
  const light = pen.createRadialGradient(x, 0, 6 * u, x, 0, 50 * u);
  light.addColorStop(0, glow);
  light.addColorStop(1, "rgb(255 205 70 / 0%)");
  pen.fillStyle = light;
  pen.beginPath();
  pen.arc(x, 0, 50 * u, 0, Math.PI * 2);
  pen.fill();
}

function rover(hand: Hand): void {
  hand.box(-10, -10.5, 22, 21, 2, "#2f9e62", 1.2);
  hand.box(-4, -4, 8.5, 8, 1, hand.ink);
  if (hand.u >= SEAMS)
    for (const y of [-9.2, 7.7]) for (let x = -7; x < 9; x += 3) hand.box(x, y, 1.5, 1.5, 0, "#f4d77a");
  hand.box(-24.5, -10, 11.5, 20, 2, "#3b4452", 1.2);
  if (hand.u >= SEAMS) hand.path("M-21.6-6v3M-23.1-4.5h3", "", "#fff", 1);
  hand.box(15.5, -15, 5, 30, 1.5, "#2f6fb8", 1.4);
}

function arm(hand: Hand, looks: Looks, lid: string, bed: string): void {
  const loads = looks.figure === "loader";
  hand.path(loads ? "M-22-13H-4V13H-22A5 5 0 0 1-27 8V-8A5 5 0 0 1-22-13Z" : "M-27-13H-4V13H-27Z", bed);
  const { pen } = hand;
  pen.save();
  // It reaches over the road, or is drawn in.
  pen.translate(looks.out ? 12 : -2, 0);
  hand.path("M-14 0H15", "", hand.ink, 11);
  hand.path("M-14 0H15", "", lid, 7);
  pen.lineCap = "round";
  pen.lineJoin = "round";
  hand.path(loads ? CLAW : FORK, "", hand.ink, 6.6);
  hand.path(loads ? CLAW : FORK, "", "#c6ccd6", 3.2);
  pen.restore();
  hand.disc(-6, 0, 13.6, lid);
  hand.path(loads ? "M-19-4.4V4.4L-25 0Z" : "M-24.2 0L-18.4-4.4V4.4Z", hand.ink, "", 0);
}

/** A store manager stands upright: `y` goes down, and its eyes look down at the boxes. */
function manager(hand: Hand, looks: Looks, lid: string, colours: FigureColours): void {
  hand.path("M15-18L21.5-24", "");
  hand.disc(22, -24.5, 3.2, lid, 1.6);
  hand.path(MANAGER, lid);
  hand.box(-17.5, 1, 35, 18, 3, SCREEN, 1.2);
  if (hand.u >= RAYS) {
    box(hand, -13, 5, 10, colours);
    const { pen } = hand;
    pen.font = fontOf(700, 14);
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.fillStyle = "#f4f6f8";
    pen.fillText(String(looks.load), 6.5, 10.5);
  }
  for (const x of [-9.5, 9.5]) eye(hand, [x, -8.4, 7.2], looks.face, "#fff", "", true);
}

/** Draws a figure with its middle at the origin, ahead to the right; `u` px a unit. */
export function drawFigure(pen: Hand["pen"], u: number, looks: Looks, colours: FigureColours): void {
  const { figure, face } = looks;
  const lid = LIDS[looks.lid % LIDS.length]?.fill ?? "#fff";
  const hand = new Hand(pen, u, colours.robotLine);
  const parts = PARTS[figure] ?? {};
  pen.save();
  pen.scale(u, u);
  pen.lineJoin = "round";
  if (figure === "store-manager") manager(hand, looks, lid, colours);
  else if (figure === "loader" || figure === "unloader") arm(hand, looks, lid, colours.bed);
  else {
    if (parts.wheel !== undefined) wheels(hand, parts.wheel, colours.wheel);
    if (figure === "kit-rover") {
      for (const y of [-24.5, 16.5]) hand.box(-12, y, 24, 8, 2.5, "#f4c430", 1.8);
      if (u >= SEAMS)
        for (const y of [-24.5, 16.5])
          hand.path(`M-6 ${String(y + 1)}v6M0 ${String(y + 1)}v6M6 ${String(y + 1)}v6`, "", hand.ink, 1.3);
    }
    if (figure === "carrier") {
      hand.path(BED, colours.bed);
      if (u >= SEAMS && looks.load === 0) hand.path("M-23-9.5H2M-23 0H2M-23 9.5H2", "", hand.ink, 1, 0.3);
    }
    hand.path(BODIES[figure] ?? "", lid);
    if (figure === "kit-rover") rover(hand);
    if (figure === "mini-robot" && u >= SEAMS) hand.path("M3-18.2Q-3.5 0 3 18.2", "", hand.ink, 1.4, 0.55);
    if (figure === "line-follower") {
      hand.path("M-24-3H17.4V3H-24Z", "#fff", "", 0, 0.85);
      if (u >= SEAMS) hand.path("M-22 0h4m4 0h4m4 0h4m4 0h4m4 0h4", "", hand.ink, 1.6, 0.75);
      pen.lineCap = "round";
      hand.path("M11-7L21-11.5M11 7L21 11.5", "", hand.ink, 7);
      hand.path("M11-7L21-11.5M11 7L21 11.5", "", lid, 3.4);
      pen.lineCap = "butt";
    }
    if (looks.load > 0) {
      if (figure === "carrier") box(hand, -24.5, -12, 24, colours);
      else box(hand, -10, -8, 16, colours);
    }
    if (parts.lamp !== undefined && (u >= SEAMS || parts.lamp[2] > 4 || looks.lamp))
      for (const place of mirrored(parts.lamp)) lampAt(hand, place, looks.lamp);
  }
  const [white, iris] =
    figure === "kit-rover" ? ["#dfe4ea", colours.robotLine] : ["#fff", figure === "line-follower" ? "#5b93dd" : ""];
  if (parts.eye !== undefined) for (const place of mirrored(parts.eye)) eye(hand, place, face, white, iris);
  if (figure === "mini-robot") hand.disc(0, 0, 3.6, "#fff", 1.5);
  pen.restore();
}

interface Sprite {
  image: OffscreenCanvas;
  half: number;
}

const sprites = new Map<string, Sprite>();
const MOST_SPRITES = 600;

/** As `drawFigure`, from a picture that was drawn once: for many robots. `ratio`: pixels of the screen a px. */
export function drawSprite(
  pen: CanvasRenderingContext2D,
  u: number,
  looks: Looks,
  colours: FigureColours,
  ratio: number,
): void {
  // Sizes in steps of a tenth, so that zooming does not draw each anew.
  const step = Math.exp(Math.round(Math.log(u) * 10) / 10);
  const key = `${step.toFixed(3)} ${Object.values(looks).join()} ${colours.robotLine} ${String(ratio)}`;
  let sprite = sprites.get(key);
  if (sprite === undefined) {
    if (sprites.size >= MOST_SPRITES) sprites.clear();
    const half = Math.ceil(44 * step);
    const image = new OffscreenCanvas(Math.ceil(2 * half * ratio), Math.ceil(2 * half * ratio));
    const paint = image.getContext("2d");
    if (paint === null) return;
    paint.setTransform(ratio, 0, 0, ratio, half * ratio, half * ratio);
    drawFigure(paint, step, looks, colours);
    sprite = { image, half };
    sprites.set(key, sprite);
  }
  const size = (sprite.half * u) / step;
  pen.drawImage(sprite.image, -size, -size, 2 * size, 2 * size);
}
