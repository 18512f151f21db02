/**
 * Programs as files to keep: SVG and PNG of the one in view, PDF of it or of all, each with the whole mission inside, so
 * that it opens again.
 *
 * The drawing is made for the occasion, outside of the page. A PNG has two dots for each px, fewer where the browser's
 * canvas would be too small for it. SVG and PNG have the colours of the theme; a PDF is paper, and has a page as large as
 * the graph: nothing is cut, and for sheets of A4 there is Print.
 */
import { api } from "../../api/client";
import { drawn } from "../../components/graph/drawn";
import { languageInUse, t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import { complain, fileName } from "../../session/document";
import { currentDrawing, type Drawing, drawProgram } from "../../session/drawing";
import { download } from "../../ui/download";
import { pdfOf } from "./pdf/pages";
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

async function missionText(): Promise<string> {
  return (await api.missionText(useStudio.getState().mission)).text;
}

async function make(): Promise<Made | null> {
  const drawing = currentDrawing();
  if (drawing === null) return null;
  const mission = await missionText();
  const picture = await drawn(drawing, { inside: mission });
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

async function exportPages(drawings: readonly Drawing[], name: string): Promise<void> {
  try {
    const mission = await missionText();
    const pages = [];
    for (const drawing of drawings) {
      pages.push({ title: drawing.program.name, svg: await drawn(drawing, { paper: true }) });
    }
    const attached = { name: fileName().replace(/(\.krt)?$/i, ".krt"), text: mission };
    const title = text(useStudio.getState().mission.label ?? {}, name);
    download(`${name}.pdf`, await pdfOf(pages, { title, language: languageInUse(), attached }), "application/pdf");
  } catch (cause) {
    complain(cause);
  }
}

/** The program in view. */
export async function exportPdf(): Promise<void> {
  const drawing = currentDrawing();
  if (drawing !== null) await exportPages([drawing], drawing.program.name);
}

/** Every program of the mission, a page each. */
export async function exportPdfOfAll(): Promise<void> {
  const state = useStudio.getState();
  const drawings = state.mission.programs.map((program) => drawProgram(state, program));
  await exportPages(drawings, fileName().replace(/\.krt$/i, ""));
}
