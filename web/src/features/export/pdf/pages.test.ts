import { expect, it } from "vitest";

import { inflate } from "./file";
import { Fonts } from "./fonts";
import { pdfOf } from "./pages";
import type { Words } from "./rest";

const FILES = import.meta.glob<string>("/node_modules/@fontsource/*/files/*-{400,600}-normal.woff", {
  query: "?inline",
  import: "default",
});

const fetchFont = async (address: string) => {
  const name = address.split("/").at(-1) ?? "";
  const [, load] = Object.entries(FILES).find(([path]) => path.endsWith(`/${name}`)) ?? [];
  if (load === undefined) throw new Error(`no ${address}`);
  const packed = atob((await load()).split(",")[1] ?? "");
  return Uint8Array.from(packed, (letter) => letter.charCodeAt(0)).buffer;
};

/** Stands in for the browser's brush, which a test has none of. */
class Told implements Words {
  readonly told: string[] = [];
  width = () => 20;
  draw = (text: string) => {
    this.told.push(text);
    return "";
  };
  write = () => Promise.resolve({ fonts: "", images: "" });
}

async function made(inner: string, told = new Told()) {
  const place = document.createElement("div");
  place.innerHTML = `<svg width="400" height="200" viewBox="-10 -20 400 200">${inner}</svg>`;
  const svg = place.firstElementChild;
  if (svg === null) throw new Error("no svg");
  const attached = { name: "mögl (1).krt", text: "<kitrobot/>" };
  const bytes = await pdfOf(
    [{ title: "ایک", svg }],
    { title: "T", language: "ur", attached },
    new Fonts(fetchFont),
    () => told,
  );
  const text = new TextDecoder("latin1").decode(bytes);
  const streams: string[] = [];
  for (const match of text.matchAll(/\/Length (\d+) >>\nstream\n/g)) {
    const at = match.index + match[0].length;
    streams.push(new TextDecoder("latin1").decode(await inflate(bytes.slice(at, at + Number(match[1])))));
  }
  return { text, streams, told: told.told };
}

it("says where each object is", async () => {
  const { text } = await made('<rect x="0" y="0" width="10" height="10" fill="#ff0000"/>');
  const table = Number(/startxref\n(\d+)/.exec(text)?.[1]);
  expect(text.slice(table, table + 4)).toBe("xref");
  const places = [...text.slice(table).matchAll(/^(\d{10}) 00000 n $/gm)].map((match) => Number(match[1]));
  expect(places.length).toBeGreaterThan(5);
  for (const [index, at] of places.entries()) {
    expect(text.slice(at, at + 12)).toMatch(new RegExp(`^${String(index + 1)} 0 obj\n`));
  }
});

it("makes a page as large as the drawing, and attaches the mission", async () => {
  const { text, streams } = await made("");
  expect(text).toContain("/MediaBox [0 0 300 150]");
  expect(text).toContain("/F (m_gl _1_.krt)");
  expect(streams).toContain("<kitrobot/>");
  expect(text).toContain("/AFRelationship /Source");
});

it("draws what stands in the drawing, each with its colours", async () => {
  const { streams } = await made(
    '<g transform="translate(5 6)" color="#00ff00"><svg width="12" viewBox="0 0 24 24" fill="none" ' +
      'stroke="currentColor" stroke-width="2"><path d="M1 1L2 2"/></svg></g>' +
      '<rect x="1" y="2" width="3" height="4" fill="#0000ff" stroke="none"/><rect width="9" height="9" fill="none"/>' +
      "<title>not drawn</title><metadata>nor this</metadata>",
  );
  const page = streams.find((one) => one.includes(" cm\n")) ?? "";
  expect(page).toContain(
    "q\n1 0 0 1 5 6 cm\nq\n0.5 0 0 0.5 0 0 cm\n0 1 0 RG 2 w 0 J 0 j [] 0 d\n1 1 m\n2 2 l\nS\nQ\nQ",
  );
  expect(page).toContain("0 0 1 rg\n1 2 3 4 re\nf");
  expect(page).not.toContain("9 9 re");
});

/** The letters of the page in the order in which they are drawn, by the fonts' way back to text. */
function letters(streams: readonly string[]): string {
  const page = streams.find((one) => one.includes("Tj")) ?? "";
  const back = streams.filter((one) => one.includes("beginbfchar"));
  return [...page.matchAll(/\/F(\d+) [^<]*<([0-9a-f]+)> Tj/g)]
    .map(([, , glyphs = ""]) =>
      (glyphs.match(/.{4}/g) ?? [])
        .map((glyph) => {
          const meant = back.map((map) => new RegExp(`<${glyph}> <([0-9a-f]+)>`).exec(map)?.[1]).find(Boolean) ?? "";
          return (meant.match(/.{4}/g) ?? []).map((unit) => String.fromCharCode(parseInt(unit, 16))).join("");
        })
        .join(""),
    )
    .join("|");
}

it("sets text that can be searched, squeezed to its length", async () => {
  const { streams, text } = await made('<text x="3" y="4" font-size="10" textLength="50" fill="#000000">Wait é</text>');
  expect(letters(streams)).toBe("Wait é");
  expect(text).toContain("/BaseFont /Inter-Regular");
  const page = streams.find((one) => one.includes("Tj")) ?? "";
  expect(Number(/([\d.]+) Tz/.exec(page)?.[1])).toBeGreaterThan(100);
});

it("sets Urdu from the right, joined, in a font that has it", async () => {
  const { streams, text } = await made('<text font-weight="600" fill="#000000">جب تک</text>');
  expect(letters(streams)).toBe("کت بج");
  expect(text).toContain("/BaseFont /NotoSansArabic-SemiBold");
});

it("leaves to the browser what no font of ours has, and only that", async () => {
  const { told, streams } = await made('<text fill="#000000">Go 等待 now 👩‍🚀!</text>');
  expect(told).toEqual(["等待", "👩‍🚀"]);
  expect(letters(streams)).toBe("Go | now |!");
});

it("makes smaller what is longer than readers allow", async () => {
  const place = document.createElement("div");
  place.innerHTML = '<svg width="100" height="96000" viewBox="0 0 100 96000"></svg>';
  const svg = place.firstElementChild;
  if (svg === null) throw new Error("no svg");
  const attached = { name: "a.krt", text: "" };
  const bytes = await pdfOf(
    [{ title: "a", svg }],
    { title: "", language: "en", attached },
    new Fonts(fetchFont),
    () => new Told(),
  );
  expect(new TextDecoder("latin1").decode(bytes)).toContain("/MediaBox [0 0 15 14400]");
});
