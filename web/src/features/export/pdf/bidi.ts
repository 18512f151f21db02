/**
 * The order in which letters stand on a line where scripts of both directions meet.
 *
 * The Unicode bidirectional algorithm for one line without control characters: strong letters, numbers, and what takes
 * its direction from its neighbours. */

export interface Run {
  /** In reading order, brackets already mirrored. */
  text: string;
  rightToLeft: boolean;
}

type Kind = "L" | "R" | "number" | "neutral";

const RIGHT = /[\u0590-\u05ff\u0600-\u08ff\ufb1d-\ufdff\ufe70-\ufefc\u{10800}-\u{10fff}\u{1e800}-\u{1efff}]/u;
const NUMBER = /[0-9\u0660-\u0669\u06f0-\u06f9]/;
const STRONG = /[\p{L}\p{Lo}\p{Extended_Pictographic}]/u;
const MARK = /\p{M}|\u200d|[\ufe00-\ufe0f]/u;
/** Signs of Arabic script that take the direction of what is around them. */
const ARABIC_NEUTRAL = /[\u060c\u061b\u061f\u066a-\u066c\u06d4]/;
const MIRROR: Readonly<Record<string, string>> = Object.fromEntries(
  ["()", "[]", "{}", "<>", "«»", "‹›", "≤≥"].flatMap((pair) => {
    const [one = "", other = ""] = pair;
    return [
      [one, other],
      [other, one],
    ];
  }),
);

function kindOf(letter: string): Kind {
  if (NUMBER.test(letter)) return "number";
  if (ARABIC_NEUTRAL.test(letter)) return "neutral";
  if (RIGHT.test(letter)) return "R";
  return STRONG.test(letter) ? "L" : "neutral";
}

/** Levels as the algorithm counts them: even runs left to right, odd right to left. */
function levelsOf(letters: readonly string[], whole: "L" | "R" | null): number[] {
  const kinds: Kind[] = [];
  for (const letter of letters) {
    const before = kinds.at(-1);
    kinds.push(MARK.test(letter) && before !== undefined ? before : kindOf(letter));
  }
  const base = (whole ?? kinds.find((kind) => kind === "L" || kind === "R")) === "R" ? 1 : 0;
  const own = base === 1 ? "R" : "L";
  let strong: "L" | "R" = own;
  // A number among Latin letters is one of them.
  const solid = kinds.map((kind) => {
    if (kind === "L" || kind === "R") strong = kind;
    return kind === "number" && strong === "L" ? "L" : kind;
  });
  const side = (kind: Kind | undefined) => (kind === undefined ? own : kind === "number" ? "R" : kind);
  const after: (Kind | undefined)[] = [];
  let next: Kind | undefined;
  for (let at = solid.length - 1; at >= 0; at--) {
    after[at] = next;
    if (solid[at] !== "neutral") next = solid[at];
  }
  let last: Kind | undefined;
  return solid.map((kind, at) => {
    if (kind === "number") {
      last = kind;
      return 2;
    }
    let is = kind;
    if (kind === "neutral") is = side(last) === side(after[at]) ? side(last) : own;
    else last = kind;
    if (is === "R") return 1;
    return base === 1 ? 2 : 0;
  });
}

/** The runs of a line from left to right; `whole` is the direction of the line, null for that of its first letter. */
export function visualRuns(line: string, whole: "L" | "R" | null = null): Run[] {
  const letters = [...line];
  if (!RIGHT.test(line)) return line === "" ? [] : [{ text: line, rightToLeft: false }];
  const levels = levelsOf(letters, whole);
  const runs: { level: number; text: string }[] = [];
  for (const [at, letter] of letters.entries()) {
    const level = levels[at] ?? 0;
    const shown = level % 2 === 1 ? (MIRROR[letter] ?? letter) : letter;
    const run = runs.at(-1);
    if (run?.level === level) run.text += shown;
    else runs.push({ level, text: shown });
  }
  for (let level = Math.max(...levels); level > 0; level--) {
    for (let start = 0; start < runs.length; start++) {
      let end = start;
      while ((runs[end]?.level ?? -1) >= level) end++;
      if (end > start + 1) runs.splice(start, end - start, ...runs.slice(start, end).reverse());
      start = Math.max(start, end);
    }
  }
  return runs.map(({ level, text }) => ({ text, rightToLeft: level % 2 === 1 }));
}
