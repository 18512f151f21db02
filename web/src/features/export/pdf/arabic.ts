/**
 * Arabic script joined: each letter in the form that its neighbours ask for, as Urdu is written.
 *
 * Unicode keeps a code point for every form, and fonts of ours have glyphs for them; which letter a form belongs to is
 * in the compatibility decomposition, so no table of letters stands here.
 */

export interface Joined {
  /** The code point to draw. */
  code: number;
  /** What it stands for, as it was typed. */
  text: string;
}

/** A letter's forms: alone, at the end, at the beginning, in the middle; a letter that joins on one side has two. */
type Forms = number[];

const FORMS = new Map<string, Forms>();
/** Lam and an alef become one form: alone, at the end. */
const LIGATURES = new Map<string, Forms>();

// B before A: together with their order this gives alone, end, beginning, middle for every letter.
for (const [from, to] of [
  [0xfe80, 0xfefc],
  [0xfb50, 0xfbe9],
  [0xfbfc, 0xfbff],
] as const) {
  for (let code = from; code <= to; code++) {
    const plain = String.fromCodePoint(code).normalize("NFKC");
    if (plain.length > 2 || plain === String.fromCodePoint(code)) continue;
    const forms = plain.length === 1 ? FORMS : LIGATURES;
    forms.set(plain, [...(forms.get(plain) ?? []), code]);
  }
}

const TRANSPARENT = /\p{Mn}/u;
const TATWEEL = "ـ";
const [END, BEGINNING, MIDDLE] = [1, 2, 3];

function joinsBefore(letter: string | undefined): boolean {
  return letter === TATWEEL || (letter !== undefined && (FORMS.get(letter)?.length ?? 0) >= 2);
}

function joinsAfter(letter: string | undefined): boolean {
  return letter === TATWEEL || (letter !== undefined && (FORMS.get(letter)?.length ?? 0) >= 4);
}

/** The letters of a text in reading order, in their forms. */
export function join(text: string): Joined[] {
  const letters = [...decomposed(text)];
  const next = (at: number, by: 1 | -1) => {
    let found = at + by;
    while (TRANSPARENT.test(letters[found] ?? "")) found += by;
    return found;
  };
  const joined: Joined[] = [];
  for (let at = 0; at < letters.length; at++) {
    const letter = letters[at] ?? "";
    const linked = joinsBefore(letter) && joinsAfter(letters[next(at, -1)]);
    const pair = LIGATURES.get(letter + (letters[at + 1] ?? ""));
    if (pair !== undefined) {
      joined.push({ code: pair[linked ? END : 0] ?? 0, text: letter + (letters[at + 1] ?? "") });
      at++;
      continue;
    }
    const forms = FORMS.get(letter);
    const onward = joinsAfter(letter) && joinsBefore(letters[next(at, 1)]);
    const form = forms?.[onward ? (linked ? MIDDLE : BEGINNING) : linked ? END : 0];
    joined.push({ code: form ?? letter.codePointAt(0) ?? 0, text: letter });
  }
  return joined;
}

/** Letters that have no form of their own as letter and mark. */
function decomposed(text: string): string {
  return [...text].map((letter) => (FORMS.has(letter) ? letter : letter.normalize("NFD"))).join("");
}
