/** The `d` of an SVG path as the operators of a PDF: lines and cubic curves, arcs turned into curves. */
import { num } from "./file";

const TOKEN = /([a-zA-Z])|([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)/g;
const COUNTS: Readonly<Record<string, number>> = { M: 2, L: 2, H: 1, V: 1, C: 6, S: 4, Q: 4, T: 2, A: 7, Z: 0 };

interface Command {
  letter: string;
  numbers: number[];
}

/** Commands with their numbers, one set each; flags of arcs may stand without a space. */
function commandsOf(d: string): Command[] {
  const commands: Command[] = [];
  for (const [, letter, body = ""] of d.matchAll(/([a-zA-Z])([^a-zA-Z]*(?:[eE][-+]?\d[^a-zA-Z]*)*)/g)) {
    if (letter === undefined) continue;
    const count = COUNTS[letter.toUpperCase()];
    if (count === undefined) continue;
    const numbers = letter.toUpperCase() === "A" ? arcNumbers(body) : [...body.matchAll(TOKEN)].map(Number0);
    if (count === 0) commands.push({ letter, numbers: [] });
    for (let at = 0; count > 0 && at + count <= numbers.length; at += count) {
      // What follows a move without a letter of its own is a line.
      const follows = at > 0 && letter.toUpperCase() === "M";
      const own = follows ? (letter === "m" ? "l" : "L") : letter;
      commands.push({ letter: own, numbers: numbers.slice(at, at + count) });
    }
  }
  return commands;
}

function Number0(match: RegExpMatchArray): number {
  return Number(match[0]);
}

function arcNumbers(body: string): number[] {
  const number = "[-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?";
  const gap = "[\\s,]*";
  const one = new RegExp(
    ["", number, number, number, "[01]", "[01]", number, number]
      .join(`${gap}`)
      .replaceAll(number, `(${number})`)
      .replaceAll("[01]", "([01])"),
    "g",
  );
  return [...body.matchAll(one)].flatMap((match) => match.slice(1).map(Number));
}

type Point = readonly [number, number];

export function pathOperators(d: string): string {
  const out: string[] = [];
  let [x, y] = [0, 0];
  let begin: Point = [0, 0];
  /** The last control point, which S and T mirror. */
  let control: Point | null = null;
  const curve = (a: Point, b: Point, to: Point) => {
    out.push(`${[...a, ...b, ...to].map(num).join(" ")} c`);
    [x, y] = to;
  };
  let before = "";
  for (const { letter, numbers } of commandsOf(d)) {
    const upper = letter.toUpperCase();
    const relative = letter !== upper;
    const [ox, oy] = relative ? [x, y] : [0, 0];
    const n = (at: number) => numbers[at] ?? 0;
    const at = (index: number): Point => [ox + n(index), oy + n(index + 1)];
    const mirrored: Point =
      control !== null && before.includes(upper === "S" ? "C" : "Q")
        ? [2 * x - control[0], 2 * y - control[1]]
        : [x, y];
    let next: Point | null = null;
    switch (upper) {
      case "M":
      case "L":
        [x, y] = at(0);
        if (upper === "M") begin = [x, y];
        out.push(`${num(x)} ${num(y)} ${upper === "M" ? "m" : "l"}`);
        break;
      case "H":
      case "V":
        if (upper === "H") x = ox + n(0);
        else y = oy + n(0);
        out.push(`${num(x)} ${num(y)} l`);
        break;
      case "C":
        next = at(2);
        curve(at(0), next, at(4));
        break;
      case "S":
        next = at(0);
        curve(mirrored, next, at(2));
        break;
      case "Q":
      case "T": {
        next = upper === "Q" ? at(0) : mirrored;
        const to = upper === "Q" ? at(2) : at(0);
        const third = (one: number, other: number) => one + ((other - one) * 2) / 3;
        curve([third(x, next[0]), third(y, next[1])], [third(to[0], next[0]), third(to[1], next[1])], to);
        break;
      }
      case "A":
        for (const [a, b, to] of arcCurves([x, y], n(0), n(1), n(2), n(3) === 1, n(4) === 1, at(5))) curve(a, b, to);
        break;
      default:
        [x, y] = begin;
        out.push("h");
    }
    control = next;
    before = upper === "S" ? "C" : upper === "T" ? "Q" : upper;
  }
  return out.join("\n");
}

/** An elliptical arc as cubic curves of a quarter turn at most (SVG 2, appendix B.2.4). */
function arcCurves(
  from: Point,
  rx: number,
  ry: number,
  degrees: number,
  large: boolean,
  sweep: boolean,
  to: Point,
): [Point, Point, Point][] {
  [rx, ry] = [Math.abs(rx), Math.abs(ry)];
  if (rx === 0 || ry === 0) return [[from, to, to]];
  const phi = (degrees * Math.PI) / 180;
  const [cos, sin] = [Math.cos(phi), Math.sin(phi)];
  const [dx, dy] = [(from[0] - to[0]) / 2, (from[1] - to[1]) / 2];
  const [x1, y1] = [cos * dx + sin * dy, -sin * dx + cos * dy];
  const grow = Math.sqrt(Math.max(1, (x1 / rx) ** 2 + (y1 / ry) ** 2));
  [rx, ry] = [rx * grow, ry * grow];
  const over = (rx * y1) ** 2 + (ry * x1) ** 2;
  if (over === 0) return [];
  const factor = (large === sweep ? -1 : 1) * Math.sqrt(Math.max(0, (rx * ry) ** 2 / over - 1));
  const [cx1, cy1] = [(factor * rx * y1) / ry, (-factor * ry * x1) / rx];
  const [cx, cy] = [cos * cx1 - sin * cy1 + (from[0] + to[0]) / 2, sin * cx1 + cos * cy1 + (from[1] + to[1]) / 2];
  const start = Math.atan2((y1 - cy1) / ry, (x1 - cx1) / rx);
  let turn = Math.atan2((-y1 - cy1) / ry, (-x1 - cx1) / rx) - start;
  if (sweep && turn < 0) turn += 2 * Math.PI;
  if (!sweep && turn > 0) turn -= 2 * Math.PI;
  const steps = Math.max(1, Math.ceil(Math.abs(turn) / (Math.PI / 2) - 1e-9));
  const reach = (4 / 3) * Math.tan(turn / steps / 4);
  const place = (angle: number, by: number): Point => {
    const [u, v] = [rx * (Math.cos(angle) - by * Math.sin(angle)), ry * (Math.sin(angle) + by * Math.cos(angle))];
    return [cx + cos * u - sin * v, cy + sin * u + cos * v];
  };
  return Array.from({ length: steps }, (_, step) => {
    const [one, other] = [start + (turn * step) / steps, start + (turn * (step + 1)) / steps];
    return [place(one, reach), place(other, -reach), step === steps - 1 ? to : place(other, 0)];
  });
}

/** A rectangle, its corners rounded by `r`. */
export function rectangle(x: number, y: number, w: number, h: number, r = 0): string {
  const radius = Math.min(r, w / 2, h / 2);
  if (radius <= 0) return `${[x, y, w, h].map(num).join(" ")} re`;
  const arc = `a ${String(radius)} ${String(radius)} 0 0 1`;
  const [across, down] = [w - 2 * radius, h - 2 * radius];
  const p = String(radius);
  const m = String(-radius);
  return pathOperators(
    `M ${String(x + radius)} ${String(y)} h ${String(across)} ${arc} ${p} ${p} v ${String(down)} ${arc} ${m} ${p} ` +
      `h ${String(-across)} ${arc} ${m} ${m} v ${String(-down)} ${arc} ${p} ${m} z`,
  );
}

export function ellipse(cx: number, cy: number, rx: number, ry: number): string {
  const arc = `a ${String(rx)} ${String(ry)} 0 0 1`;
  return pathOperators(`M ${String(cx - rx)} ${String(cy)} ${arc} ${String(2 * rx)} 0 ${arc} ${String(-2 * rx)} 0 z`);
}
