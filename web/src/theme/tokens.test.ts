import { describe, expect, it } from "vitest";

import contrastCss from "./tokens-contrast.css?raw";
import tokensCss from "./tokens.css?raw";

const ALIASES = [...tokensCss.matchAll(/--([\w-]+-tile): var\(--([\w-]+-line)\);/g)];

/** The colours of a block of CSS by name: those given as six hex digits, and those that are another one of them. */
function coloursAfter(css: string, selector: string): Record<string, string> {
  const block = css.slice(css.indexOf(selector)).split("}")[0] ?? "";
  const colours = Object.fromEntries(
    [...block.matchAll(/--([\w-]+): (#[0-9a-f]{6});/g)].map(([, name = "", value = ""]) => [name, value]),
  );
  for (const [, name = "", other = ""] of ALIASES) colours[name] ??= colours[other] ?? "";
  return colours;
}

function luminance(colour: string): number {
  const [r = 0, g = 0, b = 0] = [1, 3, 5].map((at) => {
    const share = parseInt(colour.slice(at, at + 2), 16) / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/** The contrast ratio of WCAG 2.2, 1 to 21. */
function ratio(one: string, other: string): number {
  const [light = 0, dark = 0] = [luminance(one), luminance(other)].sort((a, b) => b - a);
  return (light + 0.05) / (dark + 0.05);
}

const CATEGORIES = ["loop", "choice", "parallel", "action", "test", "team"];

/** [colour, ground]: what is read. */
const WORDS: [string, string][] = [
  ...["panel", "canvas", "chrome", "sunk", "hover", "field"].flatMap((ground): [string, string][] => [
    ["text", ground],
    ["muted", ground],
  ]),
  ["on-ink", "ink"],
  ["on-stop", "stop"],
  ["parallel-on-tile", "parallel-tile"],
  ["choice-on-tile", "choice-tile"],
  ...CATEGORIES.flatMap((one): [string, string][] => [
    [`${one}-word`, `${one}-tint`],
    [`${one}-word`, "panel"],
    [`${one}-word`, "field"],
    ["text", `${one}-tint`],
    ["muted", `${one}-tint`],
  ]),
  ...["loop", "parallel", "choice"].map((one): [string, string] => [`${one}-word`, `frame-${one}`]),
];

/** [colour, ground]: lines and icons that carry a meaning. */
const LINES: [string, string][] = [
  ["flow", "canvas"],
  ["ink", "canvas"],
  ["ink", "panel"],
  ...CATEGORIES.flatMap((one): [string, string][] => [
    [`${one}-line`, "canvas"],
    [`${one}-line`, `${one}-tint`],
    [`${one}-on-tile`, `${one}-tile`],
  ]),
];

const THEMES: [string, string, string, number, number][] = [
  ["light", tokensCss, ":root {", 4.5, 3],
  ["dark", tokensCss, ':root[data-theme="dark"]', 4.5, 3],
  ["high contrast", contrastCss, ':root[data-theme="contrast"]', 7, 4.5],
];

describe.each(THEMES)("%s", (_, css, selector, words, lines) => {
  const colours = coloursAfter(css, selector);
  const below = (pairs: [string, string][], least: number) =>
    pairs
      .map(([one, other]) => [one, other, ratio(colours[one] ?? "", colours[other] ?? "")] as const)
      .filter(([, , found]) => !(found >= least))
      .map(([one, other, found]) => `${one} on ${other}: ${found.toFixed(2)}`);

  it(`has words at ${String(words)} : 1 or more`, () => expect(below(WORDS, words)).toEqual([]));
  it(`has lines and icons at ${String(lines)} : 1 or more`, () => expect(below(LINES, lines)).toEqual([]));
  it("knows every colour of light", () => {
    const names = Object.keys(coloursAfter(tokensCss, ":root {"));
    expect(names.filter((name) => colours[name] === undefined)).toEqual([]);
  });
});

it("borders are lines too in high contrast", () => {
  const { line = "", line2 = "", panel = "", sunk = "" } = coloursAfter(contrastCss, ":root[data-theme");
  expect(Math.min(ratio(line, panel), ratio(line2, panel), ratio(line2, sunk))).toBeGreaterThanOrEqual(4.5);
});
