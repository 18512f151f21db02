/**
 * Drawings as the pages of one PDF, with a file attached to it.
 *
 * A page is as large as its drawing, a px three quarters of a point as in CSS: nothing is cut, and everything stays sharp
 * however far one zooms in. Only what is longer than readers of PDF allow is made smaller.
 */
import { Drawer, textsOf } from "./draw";
import { num, PdfFile, words } from "./file";
import { Fonts } from "./fonts";
import { BrowserWords, type Words } from "./rest";

export interface Page {
  title: string;
  /** With width, height and viewBox in px. */
  svg: Element;
}

export interface Attached {
  name: string;
  text: string;
}

const POINTS_A_PX = 0.75;
/** Points; 200 inches, where many readers stop. */
const LONGEST_SIDE = 14_400;

/** A name in a string of 8 bits, where old readers look for it. */
function plainName(name: string): string {
  return name.replace(/[^\x20-\x7e]|[()\\]/g, "_");
}

export async function pdfOf(
  pages: readonly Page[],
  { title, language, attached }: { title: string; language: string; attached: Attached },
  fonts = new Fonts(),
  rest: () => Words = () => new BrowserWords(),
): Promise<Uint8Array<ArrayBuffer>> {
  const file = new PdfFile();
  const others = rest();
  const encoder = new TextEncoder();
  const [tree, resources, outline] = [file.reserve(), file.reserve(), file.reserve()];
  for (const { svg } of pages) for (const [text, bold] of textsOf(svg)) await fonts.prepare(text, bold);
  const kids = [];
  for (const { svg } of pages) {
    const [x = 0, y = 0, width = 1, height = 1] = (svg.getAttribute("viewBox") ?? "").split(/\s+/).map(Number);
    const scale = Math.min(POINTS_A_PX, LONGEST_SIDE / Math.max(width, height));
    const place = [scale, 0, 0, -scale, -x * scale, (y + height) * scale];
    const content = `${place.map((value) => value.toFixed(6)).join(" ")} cm\n${new Drawer(fonts, others).draw(svg)}`;
    const stream = await file.stream("", encoder.encode(content));
    kids.push(
      file.add(
        `<< /Type /Page /Parent ${tree} /MediaBox [0 0 ${num(width * scale)} ${num(height * scale)}] ` +
          `/Resources ${resources} /Contents ${stream} >>`,
      ),
    );
  }
  const unseen = await others.write(file);
  file.put(resources, `<< /Font << ${await fonts.write(file)} ${unseen.fonts} >> /XObject << ${unseen.images} >> >>`);
  file.put(tree, `<< /Type /Pages /Count ${String(kids.length)} /Kids [${kids.join(" ")}] >>`);
  const items = kids.map(() => file.reserve());
  for (const [at, page] of pages.entries()) {
    const [self, kid] = [items[at], kids[at]];
    if (self === undefined || kid === undefined) continue;
    const beside = [items[at - 1] && `/Prev ${items[at - 1] ?? ""}`, items[at + 1] && `/Next ${items[at + 1] ?? ""}`];
    file.put(
      self,
      `<< /Title ${words(page.title)} /Parent ${outline} /Dest [${kid} /Fit] ${beside.filter(Boolean).join(" ")} >>`,
    );
  }
  file.put(
    outline,
    `<< /Type /Outlines /Count ${String(items.length)} /First ${items[0] ?? "null"} /Last ${items.at(-1) ?? "null"} >>`,
  );
  const held = encoder.encode(attached.text);
  const embedded = await file.stream(
    `/Type /EmbeddedFile /Subtype /application#2Fxml /Params << /Size ${String(held.length)} >>`,
    held,
  );
  const named = words(attached.name);
  const specification = file.add(
    `<< /Type /Filespec /F (${plainName(attached.name)}) /UF ${named} /AFRelationship /Source ` +
      `/EF << /F ${embedded} /UF ${embedded} >> >>`,
  );
  const root = file.add(
    `<< /Type /Catalog /Pages ${tree} /Lang (${language}) /ViewerPreferences << /DisplayDocTitle true >> ` +
      `/Outlines ${outline} /AF [${specification}] ` +
      `/Names << /EmbeddedFiles << /Names [${named} ${specification}] >> >> >>`,
  );
  return file.finish(root, file.add(`<< /Title ${words(title)} /Creator (KitRobot) >>`));
}
