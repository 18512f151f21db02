/**
 * Words in scripts that no font of ours has: drawn by the browser, as a picture of many dots, with the same words unseen
 * above it, so that they can be searched and copied like all others.
 */
import { num, type PdfFile, type Ref } from "./file";
import { toUnicode } from "./fonts";

interface Place {
  x: number;
  /** The line the letters stand on. */
  y: number;
  width: number;
  size: number;
  bold: boolean;
  colour: string;
}

/** Dots for each px: sharp on paper, and zoomed in a good way. */
const SCALE = 6;
/** Of the size, how much is kept above and below the line. */
const [ABOVE, BELOW] = [1.2, 0.5];
const FONT = "'Inter Variable', Inter, system-ui, sans-serif";
/** Codes of one unseen font. */
const MOST = 255;

export interface Words {
  width: (text: string, size: number, bold: boolean) => number;
  /** The operators that draw it. */
  draw: (text: string, place: Place) => string;
  write: (file: PdfFile) => Promise<{ fonts: string; images: string }>;
}

interface Dots {
  width: number;
  height: number;
  data: Uint8ClampedArray;
}

export class BrowserWords implements Words {
  readonly #brush: CanvasRenderingContext2D;
  readonly #pictures: Dots[] = [];
  /** Letters of the unseen fonts, by their first place. */
  readonly #letters = new Map<string, number>();

  constructor() {
    const brush = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
    if (brush === null) throw new Error("this browser draws no pictures");
    this.#brush = brush;
  }

  width(text: string, size: number, bold: boolean): number {
    this.#brush.font = this.#font(size, bold);
    return this.#brush.measureText(text).width;
  }

  draw(text: string, { x, y, width, size, bold, colour }: Place): string {
    const { canvas } = this.#brush;
    canvas.width = Math.max(1, Math.ceil(width * SCALE));
    canvas.height = Math.ceil(size * (ABOVE + BELOW) * SCALE);
    this.#brush.font = this.#font(size * SCALE, bold);
    this.#brush.fillStyle = colour;
    this.#brush.fillText(text, 0, size * ABOVE * SCALE, canvas.width);
    const { data } = this.#brush.getImageData(0, 0, canvas.width, canvas.height);
    this.#pictures.push({ width: canvas.width, height: canvas.height, data });
    const tall = size * (ABOVE + BELOW);
    const picture = `q ${num(width)} 0 0 ${num(-tall)} ${num(x)} ${num(y + size * BELOW)} cm /W${String(this.#pictures.length)} Do Q`;
    return `${picture}\n${this.#unseen(text, x, y, width, size)}`;
  }

  /** The words in a font without shapes, as wide as the picture. */
  #unseen(text: string, x: number, y: number, width: number, size: number): string {
    const letters = [...text];
    const each = (100 * width) / (size * letters.length);
    const shown = letters.map((letter) => {
      if (!this.#letters.has(letter)) this.#letters.set(letter, this.#letters.size);
      const at = this.#letters.get(letter) ?? 0;
      const code = ((at % MOST) + 1).toString(16).padStart(2, "0");
      return `/U${String(Math.floor(at / MOST))} ${num(size)} Tf <${code}> Tj`;
    });
    return `BT 3 Tr ${num(each)} Tz 1 0 0 -1 ${num(x)} ${num(y)} Tm ${shown.join(" ")} 0 Tr ET`;
  }

  #font(size: number, bold: boolean): string {
    return `${bold ? "600" : "400"} ${String(size)}px ${FONT}`;
  }

  async write(file: PdfFile): Promise<{ fonts: string; images: string }> {
    const images: string[] = [];
    for (const [at, dots] of this.#pictures.entries())
      images.push(`/W${String(at + 1)} ${await writeDots(file, dots)}`);
    const letters = [...this.#letters.keys()];
    const fonts: string[] = [];
    for (let at = 0; at < letters.length; at += MOST) {
      fonts.push(`/U${String(at / MOST)} ${await writeUnseen(file, letters.slice(at, at + MOST))}`);
    }
    return { fonts: fonts.join(" "), images: images.join(" ") };
  }
}

async function writeDots(file: PdfFile, { width, height, data }: Dots): Promise<Ref> {
  const count = width * height;
  const [colours, cover] = [new Uint8Array(3 * count), new Uint8Array(count)];
  for (let at = 0; at < count; at++) {
    colours.set(data.subarray(4 * at, 4 * at + 3), 3 * at);
    cover[at] = data[4 * at + 3] ?? 0;
  }
  const form = `/Type /XObject /Subtype /Image /Width ${String(width)} /Height ${String(height)} /BitsPerComponent 8`;
  const mask = await file.stream(`${form} /ColorSpace /DeviceGray`, cover);
  return file.stream(`${form} /ColorSpace /DeviceRGB /SMask ${mask}`, colours);
}

async function writeUnseen(file: PdfFile, letters: readonly string[]): Promise<Ref> {
  const nothing = await file.stream("", new TextEncoder().encode("1000 0 0 0 0 0 d1"));
  const count = String(letters.length);
  const encoder = new TextEncoder();
  const back = await file.stream(
    "",
    encoder.encode(
      toUnicode(
        letters.map((letter, at) => [at + 1, letter]),
        1,
      ),
    ),
  );
  const names = letters.map((_, at) => `/u${String(at + 1)}`).join(" ");
  return file.add(
    `<< /Type /Font /Subtype /Type3 /FontBBox [0 0 1000 1000] /FontMatrix [0.001 0 0 0.001 0 0] /CharProcs << ${letters
      .map((_, at) => `/u${String(at + 1)} ${nothing}`)
      .join(" ")} >> /Encoding << /Type /Encoding /Differences [1 ${names}] >> /FirstChar 1 /LastChar ${count} ` +
      `/Widths [${letters.map(() => "1000").join(" ")}] /Resources << >> /ToUnicode ${back} >>`,
  );
}
