/**
 * The program in view as a file to keep, SVG or PNG, with the whole mission inside, so that it opens again.
 *
 * The drawing is made for the occasion, outside of the page, in the colours of the theme. A PNG has two dots for each px,
 * fewer where the browser's canvas would be too small for it.
 */
import { api } from "../../api/client";
import { drawn } from "../../components/graph/drawn";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { reportError } from "../../session/document";
import { currentDrawing } from "../../session/drawing";
import { download } from "../../ui/download";

const KEYWORD = "kitrobot-mission";
const SCALE = 2;
const LONGEST_SIDE = 16_000;
const MOST_DOTS = 120_000_000;

interface Made {
  name: string;
  svg: string;
  mission: string;
  width: number;
  height: number;
}

async function make(): Promise<Made | null> {
  const drawing = currentDrawing();
  if (drawing === null) return null;
  const { text: mission } = await api.missionText(useStudio.getState().mission);
  const picture = await drawn(drawing, mission);
  const svg = new XMLSerializer().serializeToString(picture);
  const [width, height] = [Number(picture.getAttribute("width")), Number(picture.getAttribute("height"))];
  return { name: drawing.program.name, svg, mission, width, height };
}

async function dots({ svg, width, height }: Made): Promise<Uint8Array> {
  const address = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  try {
    const image = new Image();
    image.src = address;
    await image.decode();
    const scale = Math.min(SCALE, LONGEST_SIDE / Math.max(width, height), Math.sqrt(MOST_DOTS / (width * height)));
    const canvas = document.createElement("canvas");
    canvas.width = Math.round(width * scale);
    canvas.height = Math.round(height * scale);
    canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
    const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, "image/png"));
    if (blob === null) throw new Error(t("file.picture-failed"));
    return new Uint8Array(await blob.arrayBuffer());
  } finally {
    URL.revokeObjectURL(address);
  }
}

export async function exportSvg(): Promise<void> {
  try {
    const made = await make();
    if (made !== null) download(`${made.name}.svg`, made.svg, "image/svg+xml");
  } catch (cause) {
    reportError(cause);
  }
}

export async function exportPng(): Promise<void> {
  try {
    const made = await make();
    if (made === null) return;
    download(`${made.name}.png`, withText(await dots(made), KEYWORD, made.mission), "image/png");
  } catch (cause) {
    reportError(cause);
  }
}

/** PNG files: a text added to one, as the chunk iTXt that every viewer leaves alone. */
const TABLE = Uint32Array.from({ length: 256 }, (_, index) => {
  let value = index;
  for (let bit = 0; bit < 8; bit++) value = value & 1 ? (value >>> 1) ^ 0xedb88320 : value >>> 1;
  return value;
});

function crc32(bytes: Uint8Array): number {
  let value = 0xffffffff;
  for (const byte of bytes) value = (TABLE[(value ^ byte) & 0xff] ?? 0) ^ (value >>> 8);
  return (value ^ 0xffffffff) >>> 0;
}

/** Bytes of the signature and of the chunk IHDR, which must stay first. */
const HEAD = 8 + 25;

/** The picture with the text in it, uncompressed UTF-8 under the keyword. */
export function withText(png: Uint8Array, keyword: string, text: string): Uint8Array<ArrayBuffer> {
  const body = new TextEncoder().encode(`iTXt${keyword}\0\0\0\0\0${text}`);
  const chunk = new Uint8Array(body.length + 8);
  const view = new DataView(chunk.buffer);
  view.setUint32(0, body.length - 4);
  chunk.set(body, 4);
  view.setUint32(chunk.length - 4, crc32(body));
  const whole = new Uint8Array(png.length + chunk.length);
  whole.set(png.subarray(0, HEAD));
  whole.set(chunk, HEAD);
  whole.set(png.subarray(HEAD), HEAD + chunk.length);
  return whole;
}
