/**
 * A font file as far as a PDF needs it: the letters' numbers and widths, and the tables that draw them.
 *
 * WOFF 1 is the form that a page can unpack by itself: each table packed by zlib.
 */
import { inflate } from "./file";

/** What a PDF's own rendering uses of a TrueType font; shaping and names stay out. */
const KEPT = ["cvt ", "fpgm", "glyf", "head", "hhea", "hmtx", "loca", "maxp", "prep"];

export interface FontFace {
  /** The glyph of a code point; 0 when there is none. */
  glyph: (code: number) => number;
  /** Advance width in thousandths of an em. */
  advance: (glyph: number) => number;
  /** Thousandths of an em. */
  ascent: number;
  descent: number;
  box: readonly [number, number, number, number];
  /** The TrueType file to embed. */
  file: Uint8Array<ArrayBuffer>;
}

interface Table {
  tag: string;
  sum: number;
  bytes: Uint8Array<ArrayBuffer>;
}

export async function readWoff(data: ArrayBuffer): Promise<FontFace> {
  const view = new DataView(data);
  if (view.getUint32(0) !== 0x774f4646) throw new Error("not a WOFF file");
  const tables = new Map<string, Table>();
  for (let index = 0; index < view.getUint16(12); index++) {
    const at = 44 + 20 * index;
    const tag = String.fromCharCode(...new Uint8Array(data, at, 4));
    const [offset, packed, length, sum] = [4, 8, 12, 16].map((by) => view.getUint32(at + by)) as [
      number,
      number,
      number,
      number,
    ];
    const bytes = new Uint8Array(data.slice(offset, offset + packed));
    tables.set(tag, { tag, sum, bytes: packed < length ? await inflate(bytes) : bytes });
  }
  const table = (tag: string) => {
    const { bytes } = tables.get(tag) ?? { bytes: new Uint8Array() };
    return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  };
  const [head, hhea, hmtx] = [table("head"), table("hhea"), table("hmtx")];
  const per = 1000 / head.getUint16(18);
  const measured = hhea.getUint16(34);
  const glyphs = readCmap(table("cmap"));
  return {
    glyph: (code) => glyphs.get(code) ?? 0,
    advance: (glyph) => hmtx.getUint16(4 * Math.min(glyph, measured - 1)) * per,
    ascent: hhea.getInt16(4) * per,
    descent: hhea.getInt16(6) * per,
    box: [36, 38, 40, 42].map((at) => head.getInt16(at) * per) as [number, number, number, number],
    file: sfnt(KEPT.flatMap((tag) => tables.get(tag) ?? [])),
  };
}

/** Code point → glyph, from the widest table of the font. */
function readCmap(cmap: DataView): Map<number, number> {
  const glyphs = new Map<number, number>();
  for (let index = 0; index < cmap.getUint16(2); index++) {
    const at = cmap.getUint32(8 + 8 * index);
    const format = cmap.getUint16(at);
    if (format === 4) readSegments(cmap, at, glyphs);
    if (format === 12) readGroups(cmap, at, glyphs);
  }
  return glyphs;
}

function readSegments(cmap: DataView, at: number, glyphs: Map<number, number>): void {
  const twice = cmap.getUint16(at + 6);
  for (let by = 0; by < twice; by += 2) {
    const end = cmap.getUint16(at + 14 + by);
    const start = cmap.getUint16(at + 16 + twice + by);
    const delta = cmap.getUint16(at + 16 + 2 * twice + by);
    const place = at + 16 + 3 * twice + by;
    const range = cmap.getUint16(place);
    for (let code = start; code <= end && code < 0xffff; code++) {
      const found = range === 0 ? code : cmap.getUint16(place + range + 2 * (code - start));
      if (found !== 0) glyphs.set(code, (found + delta) & 0xffff);
    }
  }
}

function readGroups(cmap: DataView, at: number, glyphs: Map<number, number>): void {
  for (let group = 0; group < cmap.getUint32(at + 12); group++) {
    const [start, end, glyph] = [16, 20, 24].map((by) => cmap.getUint32(at + by + 12 * group)) as [
      number,
      number,
      number,
    ];
    for (let code = start; code <= end; code++) glyphs.set(code, glyph + code - start);
  }
}

/** Tables as one TrueType file. */
function sfnt(tables: Table[]): Uint8Array<ArrayBuffer> {
  const head = 12 + 16 * tables.length;
  const padded = (length: number) => (length + 3) & ~3;
  const file = new Uint8Array(tables.reduce((sum, { bytes }) => sum + padded(bytes.length), head));
  const view = new DataView(file.buffer);
  const power = 2 ** Math.floor(Math.log2(tables.length));
  view.setUint32(0, 0x00010000);
  view.setUint16(4, tables.length);
  view.setUint16(6, 16 * power);
  view.setUint16(8, Math.log2(power));
  view.setUint16(10, 16 * (tables.length - power));
  let at = head;
  for (const [index, { tag, sum, bytes }] of tables.entries()) {
    const record = 12 + 16 * index;
    for (let letter = 0; letter < 4; letter++) file[record + letter] = tag.charCodeAt(letter);
    view.setUint32(record + 4, sum);
    view.setUint32(record + 8, at);
    view.setUint32(record + 12, bytes.length);
    file.set(bytes, at);
    at += padded(bytes.length);
  }
  return file;
}
