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
import { complain } from "../../session/document";
import { currentDrawing } from "../../session/drawing";
import { download } from "../../ui/download";
import { withText } from "./png";

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
    complain(cause);
  }
}

export async function exportPng(): Promise<void> {
  try {
    const made = await make();
    if (made === null) return;
    download(`${made.name}.png`, withText(await dots(made), KEYWORD, made.mission), "image/png");
  } catch (cause) {
    complain(cause);
  }
}
