/**
 * The fonts of a PDF: which of ours has a letter, what a line of text becomes, and the font objects of the file.
 *
 * Inter and Noto Sans Arabic travel with the page, in pieces by script; a piece is fetched when a letter of it is wanted.
 * Each becomes a font whose codes are its glyphs, with the way back to letters, so that text can be searched and copied.
 * Letters that none of them has come back as words to be drawn by the browser.
 */
import arabic400 from "@fontsource/noto-sans-arabic/files/noto-sans-arabic-arabic-400-normal.woff?url";
import arabic600 from "@fontsource/noto-sans-arabic/files/noto-sans-arabic-arabic-600-normal.woff?url";
import cyrillic400 from "@fontsource/inter/files/inter-cyrillic-400-normal.woff?url";
import cyrillic600 from "@fontsource/inter/files/inter-cyrillic-600-normal.woff?url";
import greek400 from "@fontsource/inter/files/inter-greek-400-normal.woff?url";
import greek600 from "@fontsource/inter/files/inter-greek-600-normal.woff?url";
import latin400 from "@fontsource/inter/files/inter-latin-400-normal.woff?url";
import latin600 from "@fontsource/inter/files/inter-latin-600-normal.woff?url";
import latinMore400 from "@fontsource/inter/files/inter-latin-ext-400-normal.woff?url";
import latinMore600 from "@fontsource/inter/files/inter-latin-ext-600-normal.woff?url";
import vietnamese400 from "@fontsource/inter/files/inter-vietnamese-400-normal.woff?url";
import vietnamese600 from "@fontsource/inter/files/inter-vietnamese-600-normal.woff?url";

import { join } from "./arabic";
import { visualRuns } from "./bidi";
import { num, type PdfFile, type Ref, utf16 } from "./file";
import { type FontFace, readWoff } from "./woff";

interface Source {
  name: string;
  letters: RegExp;
  regular: string;
  bold: string;
}

/** The first that may have a letter and does, has it. */
const SOURCES: readonly Source[] = [
  {
    name: "Inter",
    letters: /[\0-\u0131\u0152\u0153\u02bb-\u02dc\u2000-\u206f\u20ac\u2122\u2191\u2193\u2212\u2215]/,
    regular: latin400,
    bold: latin600,
  },
  {
    name: "InterExt",
    letters: /[\u0100-\u02ff\u1e00-\u1eff\u2020\u20a0-\u20c0\u2113]/,
    regular: latinMore400,
    bold: latinMore600,
  },
  {
    name: "InterVietnamese",
    letters: /[\u0102-\u01b0\u1ea0-\u1ef9\u20ab]/,
    regular: vietnamese400,
    bold: vietnamese600,
  },
  {
    name: "InterCyrillic",
    letters: /[\u0400-\u045f\u0490\u0491\u04b0\u04b1\u2116]/,
    regular: cyrillic400,
    bold: cyrillic600,
  },
  { name: "InterGreek", letters: /[\u0370-\u03ff]/, regular: greek400, bold: greek600 },
  {
    name: "NotoSansArabic",
    letters: /[\u0600-\u06ff\u0750-\u077f\ufb50-\ufdff\ufe70-\ufefc]/,
    regular: arabic400,
    bold: arabic600,
  },
];

export type Fetch = (address: string) => Promise<ArrayBuffer>;

async function fetchFont(address: string): Promise<ArrayBuffer> {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address}: ${String(response.status)}`);
  return response.arrayBuffer();
}

/** A font that the file needs, and the letters that its glyphs stand for. */
export interface Font {
  name: string;
  source: string;
  face: FontFace;
  used: Map<number, string>;
}

/** What stands side by side on a line, from left to right: glyphs of one font, or words that no font of ours has. */
export type Piece =
  | { kind: "glyphs"; font: Font; glyphs: number[]; /** Thousandths of the letters' size. */ width: number }
  | { kind: "words"; text: string };

interface Letter {
  code: number;
  text: string;
}

const SPACE = 0x20;
const graphemes = new Intl.Segmenter();

export class Fonts {
  readonly #fetch: Fetch;
  readonly #fonts = new Map<string, Font>();

  constructor(fetch: Fetch = fetchFont) {
    this.#fetch = fetch;
  }

  /** Fetches what a text needs; to be waited for before it is set. */
  async prepare(text: string, bold: boolean): Promise<void> {
    for (const source of SOURCES) {
      const address = bold ? source.bold : source.regular;
      if (this.#fonts.has(address) || !source.letters.test(text)) continue;
      const face = await readWoff(await this.#fetch(address));
      const name = `F${String(this.#fonts.size + 1)}`;
      this.#fonts.set(address, {
        name,
        source: `${source.name}-${bold ? "SemiBold" : "Regular"}`,
        face,
        used: new Map(),
      });
    }
  }

  /** A line of text in its order on the page; `whole` as in `visualRuns`. */
  set(line: string, bold: boolean, whole: "L" | "R" | null = null): Piece[] {
    const pieces: Piece[] = [];
    for (const { text, rightToLeft } of visualRuns(line.normalize("NFC"), whole)) {
      if (rightToLeft) this.#setRightToLeft(text, bold, pieces);
      else for (const { segment } of graphemes.segment(text)) this.#place(this.#plain(segment), segment, bold, pieces);
    }
    return pieces;
  }

  #plain(segment: string): Letter[] {
    return [...segment].map((letter) => ({ code: letter.codePointAt(0) ?? 0, text: letter }));
  }

  #setRightToLeft(text: string, bold: boolean, pieces: Piece[]): void {
    const letters: Letter[] = join(text).reverse();
    // The browser orders by itself what it draws by itself.
    if (letters.some(({ code }) => this.#fontOf(code, bold) === null)) pieces.push({ kind: "words", text });
    else for (const letter of letters) this.#place([letter], letter.text, bold, pieces);
  }

  #place(letters: Letter[], text: string, bold: boolean, pieces: Piece[]): void {
    const last = pieces.at(-1);
    // A space is of the font before it.
    const before = last?.kind === "glyphs" && text === " " && last.font.face.glyph(SPACE) !== 0 ? last.font : null;
    const fonts = letters.map(({ code }) => before ?? this.#fontOf(code, bold));
    if (fonts.includes(null)) {
      if (last?.kind === "words") last.text += text;
      else pieces.push({ kind: "words", text });
      return;
    }
    for (const [at, { code, text: meant }] of letters.entries()) {
      const font = fonts[at];
      if (font === null || font === undefined) continue;
      const glyph = font.face.glyph(code);
      if (!font.used.has(glyph)) font.used.set(glyph, meant);
      let piece = pieces.at(-1);
      if (piece?.kind !== "glyphs" || piece.font !== font) {
        piece = { kind: "glyphs", font, glyphs: [], width: 0 };
        pieces.push(piece);
      }
      piece.glyphs.push(glyph);
      piece.width += font.face.advance(glyph);
    }
  }

  #fontOf(code: number, bold: boolean): Font | null {
    const letter = String.fromCodePoint(code);
    for (const source of SOURCES) {
      if (!source.letters.test(letter)) continue;
      const font = this.#fonts.get(bold ? source.bold : source.regular);
      if (font !== undefined && font.face.glyph(code) !== 0) return font;
    }
    return null;
  }

  /** Writes the fonts that were used; gives the entries of a resource dictionary. */
  async write(file: PdfFile): Promise<string> {
    const entries: string[] = [];
    for (const font of this.#fonts.values()) {
      if (font.used.size > 0) entries.push(`/${font.name} ${await writeFont(file, font)}`);
    }
    return entries.join(" ");
  }
}

async function writeFont(file: PdfFile, { source, face, used }: Font): Promise<Ref> {
  const program = await file.stream(`/Length1 ${String(face.file.length)}`, face.file);
  const { ascent, descent, box } = face;
  const descriptor = file.add(
    `<< /Type /FontDescriptor /FontName /${source} /Flags 4 /FontBBox [${box.map(num).join(" ")}] /ItalicAngle 0 ` +
      `/Ascent ${num(ascent)} /Descent ${num(descent)} /CapHeight ${num(ascent)} /StemV 80 /FontFile2 ${program} >>`,
  );
  const glyphs = [...used.keys()].sort((one, other) => one - other);
  const widths = glyphs.map((glyph) => `${String(glyph)} [${num(face.advance(glyph))}]`).join(" ");
  const inner = file.add(
    `<< /Type /Font /Subtype /CIDFontType2 /BaseFont /${source} /CIDToGIDMap /Identity /DW 0 /W [${widths}] ` +
      `/CIDSystemInfo << /Registry (Adobe) /Ordering (Identity) /Supplement 0 >> /FontDescriptor ${descriptor} >>`,
  );
  const back = await file.stream(
    "",
    new TextEncoder().encode(
      toUnicode(
        glyphs.map((one) => [one, used.get(one) ?? ""]),
        2,
      ),
    ),
  );
  return file.add(
    `<< /Type /Font /Subtype /Type0 /BaseFont /${source} /Encoding /Identity-H /DescendantFonts [${inner}] ` +
      `/ToUnicode ${back} >>`,
  );
}

/** The way from codes of so many bytes back to text. */
export function toUnicode(codes: readonly (readonly [number, string])[], bytes: 1 | 2): string {
  const code = (value: number) => `<${value.toString(16).padStart(2 * bytes, "0")}>`;
  const blocks: string[] = [];
  // A block holds a hundred at most.
  for (let at = 0; at < codes.length; at += 100) {
    const some = codes.slice(at, at + 100).map(([one, text]) => `${code(one)} <${utf16(text)}>`);
    blocks.push(`${String(some.length)} beginbfchar\n${some.join("\n")}\nendbfchar`);
  }
  return [
    "/CIDInit /ProcSet findresource begin 12 dict begin begincmap",
    "/CIDSystemInfo << /Registry (Adobe) /Ordering (UCS) /Supplement 0 >> def",
    "/CMapName /Adobe-Identity-UCS def /CMapType 2 def",
    `1 begincodespacerange ${code(0)} ${code(256 ** bytes - 1)} endcodespacerange`,
    ...blocks,
    "endcmap CMapName currentdict /CMap defineresource pop end end",
  ].join("\n");
}
