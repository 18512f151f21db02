/**
 * An SVG of ours as the content of a PDF page: shapes, lines, text and icons, as `GraphDrawing` makes them.
 *
 * It knows the elements and attributes that stand in such a drawing, not all of SVG. Colours are #rrggbb, none or
 * currentColor. Text is squeezed to its `textLength`, as in the SVG, and into its `data-room`
 * where it would be wider.
 */
import { num } from "./file";
import type { Fonts, Piece } from "./fonts";
import { ellipse, pathOperators, rectangle } from "./path";
import type { Words } from "./rest";

interface Style {
  fill: string;
  stroke: string;
  colour: string;
  width: number;
  cap: string;
  join: string;
  dash: string;
  size: number;
  weight: number;
  anchor: string;
}

const PLAIN: Style = {
  fill: "#000000",
  stroke: "none",
  colour: "#000000",
  width: 1,
  cap: "butt",
  join: "miter",
  dash: "none",
  size: 16,
  weight: 400,
  anchor: "start",
};

const CAPS: Readonly<Record<string, number>> = { butt: 0, round: 1, square: 2 };
const JOINS: Readonly<Record<string, number>> = { miter: 0, round: 1, bevel: 2 };
/** From here on the 600 of ours is nearer than the 400. */
const BOLD_FROM = 550;

/** Texts of a drawing, each with whether it is bold. */
export function textsOf(svg: Element): [text: string, bold: boolean][] {
  return [...svg.querySelectorAll("text")].map((element) => [
    element.textContent,
    Number(element.getAttribute("font-weight") ?? 400) >= BOLD_FROM,
  ]);
}

function styleOf(element: Element, from: Style): Style {
  const of = (name: string, otherwise: string) => element.getAttribute(name) ?? otherwise;
  const colour = of("color", from.colour);
  return {
    colour,
    fill: of("fill", from.fill),
    stroke: of("stroke", from.stroke),
    width: Number(of("stroke-width", String(from.width))),
    cap: of("stroke-linecap", from.cap),
    join: of("stroke-linejoin", from.join),
    dash: of("stroke-dasharray", from.dash),
    size: Number(of("font-size", String(from.size))),
    weight: Number(of("font-weight", String(from.weight))),
    anchor: of("text-anchor", from.anchor),
  };
}

/** A colour's three parts, 0…1; null for none. */
function rgb(paint: string, { colour }: Style): string | null {
  const value = paint === "currentColor" ? colour : paint;
  const short = /^#([0-9a-f])([0-9a-f])([0-9a-f])$/i.exec(value);
  const whole =
    short === null
      ? value
      : `#${short
          .slice(1)
          .map((digit) => digit + digit)
          .join("")}`;
  const match = /^#([0-9a-f]{2})([0-9a-f]{2})([0-9a-f]{2})/i.exec(whole);
  return match === null
    ? null
    : match
        .slice(1)
        .map((part) => num(parseInt(part, 16) / 255))
        .join(" ");
}

/** The operators that draw an element and all in it. */
export class Drawer {
  readonly #fonts: Fonts;
  readonly #words: Words;
  readonly #out: string[] = [];

  constructor(fonts: Fonts, words: Words) {
    this.#fonts = fonts;
    this.#words = words;
  }

  draw(svg: Element): string {
    for (const child of svg.children) this.#element(child, styleOf(svg, PLAIN));
    return this.#out.join("\n");
  }

  #element(element: Element, from: Style): void {
    const style = styleOf(element, from);
    const n = (name: string) => Number(element.getAttribute(name) ?? 0);
    switch (element.localName) {
      case "g":
      case "svg":
        this.#group(element, style);
        break;
      case "rect":
        this.#shape(rectangle(n("x"), n("y"), n("width"), n("height"), n("rx")), style);
        break;
      case "circle":
        this.#shape(ellipse(n("cx"), n("cy"), n("r"), n("r")), style);
        break;
      case "ellipse":
        this.#shape(ellipse(n("cx"), n("cy"), n("rx"), n("ry")), style);
        break;
      case "line":
        this.#shape(
          pathOperators(`M ${String(n("x1"))} ${String(n("y1"))} L ${String(n("x2"))} ${String(n("y2"))}`),
          style,
        );
        break;
      case "polygon":
      case "polyline": {
        const end = element.localName === "polygon" ? "z" : "";
        this.#moved(element, () =>
          this.#shape(pathOperators(`M ${element.getAttribute("points") ?? ""} ${end}`), style),
        );
        break;
      }
      case "path":
        this.#moved(element, () => this.#shape(pathOperators(element.getAttribute("d") ?? ""), style));
        break;
      case "text":
        this.#text(element, style);
        break;
      // Titles and metadata draw nothing.
    }
  }

  #group(element: Element, style: Style): void {
    this.#moved(element, () => {
      for (const child of element.children) this.#element(child, style);
    });
  }

  /** Inside of an element's own place and scale. */
  #moved(element: Element, inside: () => void): void {
    const place = /translate\(\s*([-\d.e]+)[\s,]+([-\d.e]+)\s*\)/.exec(element.getAttribute("transform") ?? "");
    const box = element.localName === "svg" ? (element.getAttribute("viewBox") ?? "").split(/[\s,]+/).map(Number) : [];
    const scale = box.length === 4 ? Number(element.getAttribute("width") ?? box[2]) / (box[2] ?? 1) : 1;
    const [x, y] = [Number(place?.[1] ?? 0), Number(place?.[2] ?? 0)];
    if (x === 0 && y === 0 && scale === 1) {
      inside();
      return;
    }
    this.#out.push("q", `${num(scale)} 0 0 ${num(scale)} ${num(x)} ${num(y)} cm`);
    inside();
    this.#out.push("Q");
  }

  #shape(path: string, style: Style): void {
    const [fill, stroke] = [rgb(style.fill, style), rgb(style.stroke, style)];
    const stroked = stroke !== null && style.width > 0;
    if (path === "" || (fill === null && !stroked)) return;
    if (fill !== null) this.#out.push(`${fill} rg`);
    if (stroked) {
      const dash =
        style.dash === "none"
          ? ""
          : style.dash
              .split(/[\s,]+/)
              .map((part) => num(Number(part)))
              .join(" ");
      this.#out.push(
        `${stroke} RG ${num(style.width)} w ${String(CAPS[style.cap] ?? 0)} J ${String(JOINS[style.join] ?? 0)} j [${dash}] 0 d`,
      );
    }
    this.#out.push(path, fill === null ? "S" : stroked ? "B" : "f");
  }

  #text(element: Element, style: Style): void {
    const fill = rgb(style.fill, style);
    const bold = style.weight >= BOLD_FROM;
    const runsLeft = element.getAttribute("direction") === "rtl";
    const pieces = this.#fonts.set(element.textContent, bold, runsLeft ? "R" : null);
    if (fill === null || pieces.length === 0) return;
    const { size } = style;
    const widths = pieces.map((piece) => this.#width(piece, size, bold));
    const natural = widths.reduce((sum, width) => sum + width, 0);
    const room = Number(element.getAttribute("data-room") ?? natural);
    const wanted = Number(element.getAttribute("textLength") ?? Math.min(natural, room));
    const squeeze = natural > 0 ? wanted / natural : 1;
    let x = Number(element.getAttribute("x") ?? 0);
    if (style.anchor === "middle") x -= wanted / 2;
    if (style.anchor === (runsLeft ? "start" : "end")) x -= wanted;
    const y = Number(element.getAttribute("y") ?? 0);
    for (const [at, piece] of pieces.entries()) {
      const width = (widths[at] ?? 0) * squeeze;
      if (piece.kind === "words") {
        this.#out.push(this.#words.draw(piece.text, { x, y, width, size, bold, colour: style.fill }));
      } else {
        const glyphs = piece.glyphs.map((glyph) => glyph.toString(16).padStart(4, "0")).join("");
        this.#out.push(
          `BT ${fill} rg /${piece.font.name} ${num(size)} Tf ${num(100 * squeeze)} Tz 1 0 0 -1 ${num(x)} ${num(y)} Tm <${glyphs}> Tj ET`,
        );
      }
      x += width;
    }
  }

  #width(piece: Piece, size: number, bold: boolean): number {
    return piece.kind === "words" ? this.#words.width(piece.text, size, bold) : (piece.width * size) / 1000;
  }
}
