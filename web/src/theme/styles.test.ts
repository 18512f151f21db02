import { expect, it } from "vitest";

type Texts = Record<string, string>;

const SHEETS = import.meta.glob<string>("../**/*.css", { query: "?raw", import: "default", eager: true }) as Texts;
const SOURCES = import.meta.glob<string>(["../**/*.{ts,tsx}", "!../**/*.test.*", "!../api/generated.ts"], {
  query: "?raw",
  import: "default",
  eager: true,
}) as Texts;

const css = Object.values(SHEETS)
  .join("\n")
  .replaceAll(/\/\*.*?\*\//gs, "");
const source = Object.values(SOURCES).join("\n");

function found(text: string, pattern: RegExp): Set<string> {
  return new Set([...text.matchAll(pattern)].map(([, name = ""]) => name));
}

it("every variable that is read is written somewhere", () => {
  const written = new Set([...found(css + source, /(--[\w-]+)\s*:/g), ...found(source, /["'`](--[\w-]+)["'`]/g)]);
  // What ends in a hyphen is the beginning of a name.
  const read = found(css + source, /var\(\s*(--[\w-]*\w)[\s,)]/g);
  expect([...read].filter((name) => !written.has(name))).toEqual([]);
});

it("every class that has a rule stands in the source, whole or as `beginning-${…}`", () => {
  const words = found(source, /(?<![\w-])([A-Za-z][\w-]*)/g);
  const beginnings = [...found(source, /([\w-]+-)(?:\$\{|"(?: \+|,))/g)];
  const classes = [...found(css.replaceAll(/\{[^{}]*\}/g, "{}"), /\.([A-Za-z_][\w-]*)/g)];
  expect(classes.length).toBeGreaterThan(500);
  const ofOthers = /^(cm|lucide)-/;
  expect(
    classes.filter(
      (name) => !words.has(name) && !ofOthers.test(name) && !beginnings.some((one) => name.startsWith(one)),
    ),
  ).toEqual([]);
});

/** `file: declaration`, of the rules that are not tokens themselves. */
function declarations(property: string): string[] {
  const pattern = new RegExp(`(?<=[;{\\s])(?:${property}): ([^;}]+)`, "g");
  return Object.entries(SHEETS)
    .filter(([path]) => !path.endsWith("/tokens.css"))
    .flatMap(([path, text]) => [...text.matchAll(pattern)].map(([words]) => `${path}: ${words}`));
}

it("every layer is a token", () => {
  const layers = declarations("z-index");
  expect(layers.length).toBeGreaterThan(30);
  expect(layers.filter((one) => !/: var\(--layer-[\w-]+\)( !important)?$/.test(one))).toEqual([]);
});

// Paper is measured in points; what fills a wall goes by the window's width.
it("every size of letters on a screen is a token", () => {
  const sizes = declarations("font-size|font");
  expect(sizes.length).toBeGreaterThan(100);
  expect(sizes.filter((one) => /[\d.](?:px|rem)/.test(one) && !one.includes("clamp("))).toEqual([]);
});
